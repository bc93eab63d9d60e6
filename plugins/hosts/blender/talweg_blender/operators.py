"""Smooth selected edges, or annotations, on a mesh; with a redo panel."""

import math

import bpy

from . import curve_object, cutting, drawings, parameters, session
from .package import talweg


class _Smoothing:
    """What both operators do with a drawing."""

    bl_options = {"REGISTER", "UNDO"}

    def smooth(self, context, obj, curves_on):
        """Smooths curves_on(arrays of the mesh) and shows the result; what goes wrong becomes an
        error report."""
        warnings = []
        try:
            arrays = drawings.MeshArrays(obj.data)
            if not len(arrays.triangles):
                raise talweg.BadMesh("The mesh has no faces.")
            curves = curves_on(arrays)
            result = self._result(context, arrays, curves)
            if self.output == "CURVE":
                made = curve_object.add(obj, result, self.thickness)
                self.report({"INFO"}, _sentence(result) + f" Curve: {made.name}.")
            else:
                warnings = self._cut(context, obj, arrays, result)
                self.report({"INFO"}, _sentence(result))
        except (talweg.Error, KeyboardInterrupt) as error:
            self.report({"ERROR"}, str(error) or "Interrupted.")
            return {"CANCELLED"}
        parameters.show_used(self, result.total)
        for warning in (*warnings, *result.total.warnings):
            self.report({"WARNING"}, warning)
        if max(obj.scale) - min(obj.scale) > 1e-6 * max(map(abs, obj.scale)):
            self.report({"WARNING"}, "The object is scaled unevenly; lengths are those of the "
                                     "unscaled mesh (Ctrl A applies the scale).")
        return {"FINISHED"}

    def _result(self, context, arrays, curves):
        manager = context.window_manager
        manager.progress_begin(0, 1)
        try:
            return session.smooth(arrays, curves, parameters.values(self),
                                  lambda stage, fraction: manager.progress_update(fraction))
        finally:
            manager.progress_end()

    def _cut(self, context, obj, arrays, result):
        warnings = cutting.cut(obj, arrays, result.curves)[1]
        context.tool_settings.mesh_select_mode = (False, True, False)
        return warnings

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        parameters.draw(layout, self)
        layout.prop(self, "output")
        if self.output == "CURVE":
            layout.prop(self, "thickness")
        if hasattr(self, "closed"):
            layout.prop(self, "closed")
            layout.prop(self, "thin")


def _sentence(result):
    r = result.total
    return (f"Curvature {r.curvature_before:.3g} to {r.curvature_after:.3g} rad, "
            f"bending {r.bending_before:.3g} to {r.bending_after:.3g}, "
            f"{math.degrees(r.window_turning_after):.0f} degrees in one edge, no farther than "
            f"{r.deviation_to_drawn_max:.3g} from the drawing.")


_COMMON = {
    "output": bpy.props.EnumProperty(
        name="Result", default="CURVE",
        items=[("CURVE", "Curve object", "A curve object on the surface"),
               ("EDGES", "Edges of the mesh", "Cut into the mesh as selected edges")]),
    "thickness": bpy.props.FloatProperty(name="Thickness", default=0, min=0, soft_max=0.1,
                                         subtype="DISTANCE", precision=4,
                                         description="Bevel of the curve object"),
}


_STROKES = {
    "closed": bpy.props.BoolProperty(name="Closed", description="Strokes are loops"),
    "thin": bpy.props.FloatProperty(
        name="Thin out", default=0.5, min=0, soft_max=4,
        description="Points of a stroke are at least so many mean edges of the mesh apart"),
}


class TALWEG_OT_smooth_edges(_Smoothing, bpy.types.Operator):
    """Smooth the selected edges as curves on the surface, close to where they are"""

    bl_idname = "talweg.smooth_edges"
    bl_label = "Smooth Curve on Surface"

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.mode == "EDIT" \
            and context.object.type == "MESH"

    def execute(self, context):
        obj = context.object
        obj.update_from_editmode()
        return self.smooth(context, obj, lambda arrays: drawings.selected_edges(obj.data))


class TALWEG_OT_smooth_annotations(_Smoothing, bpy.types.Operator):
    """Smooth the strokes of the active annotation layer on the active mesh"""

    bl_idname = "talweg.smooth_annotations"
    bl_label = "Smooth Annotations on Surface"

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.mode == "OBJECT" \
            and context.object.type == "MESH"

    def execute(self, context):
        return self.smooth(context, context.object, lambda arrays: drawings.annotation_strokes(
            context, context.object, self.closed, self.thin * drawings.mean_edge(arrays)))


CLASSES = (TALWEG_OT_smooth_edges, TALWEG_OT_smooth_annotations)


def register():
    for cls in CLASSES:
        cls.__annotations__ = {**parameters.annotations(), **_COMMON}
    TALWEG_OT_smooth_annotations.__annotations__.update(_STROKES)
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
