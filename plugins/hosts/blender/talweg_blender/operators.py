"""Smooth selected edges, or annotations, on a mesh; with a redo panel."""

import math
import textwrap

import bpy
import numpy as np

from . import curve_object, cutting, drawings, parameters, session, strokes, surface
from .naming import named
from .package import talweg


class _Smoothing:
    """What both operators do with a drawing."""

    bl_options = {"REGISTER", "UNDO"}

    def smooth(self, context, obj, drawing_on, as_shown):
        """Smooths drawing_on(surface) and shows the result; what goes wrong becomes an error report.

        :param as_shown: on the mesh with its modifiers.
        """
        self.warned = ""
        try:
            place = surface.Surface(context, obj, as_shown)
            self.mean_edge = place.edge
            drawing = drawing_on(place)
            with named(drawing.names):
                result = self._result(context, place.arrays, drawing.curves)
                told, warnings = self._shown(context, obj, place, drawing, result)
        except (talweg.Error, KeyboardInterrupt) as error:
            self.report({"ERROR"}, str(error) or "Interrupted.")
            return {"CANCELLED"}
        parameters.show_used(self, result.total)
        self._first_of_all = [*drawing.warnings, *_of_object(obj, as_shown)]
        self._tell(f"{_sentence(result)} {told}".strip(), [
            *self._first_of_all, *warnings,
            *(one for one in result.total.warnings if not _is_measured(one, drawing))])
        return {"FINISHED"}

    def _tell(self, told, warnings):
        """One report: of several the status bar shows only the last. The panel keeps the warnings."""
        self.warned = "\n".join(warnings)
        self.report({"WARNING"} if warnings else {"INFO"}, " ".join([told, *warnings]))

    def invoke(self, context, _event):
        """As execute(); what is to be read before going on is shown where the pointer is."""
        self._first_of_all = []
        outcome = self.execute(context)
        lines = self._first_of_all
        if lines and not bpy.app.background:
            context.window_manager.popup_menu(
                lambda popup, _: _draw_lines(popup.layout, lines, 80), title="Talweg", icon="ERROR")
        return outcome

    def _shown(self, context, obj, place, drawing, result):
        """The result as it is asked for: a sentence, and warnings."""
        if self.output == "EDGES":
            return "", self._cut(context, obj, place.arrays, result)
        bevel = curve_object.radius(place, self.thickness)
        return f"Curve: {curve_object.put(context, obj, result, drawing.key, bevel).name}.", []

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
        _draw_lines(layout, self.warned.splitlines(), 44)
        layout.use_property_split = True
        layout.use_property_decorate = False
        parameters.draw(layout, self)
        layout.prop(self, "output")
        if self.output == "CURVE":
            layout.prop(self, "thickness")
        for name in _STROKES:
            if hasattr(self, name):
                layout.prop(self, name)


def _draw_lines(layout, lines, width):
    """Warnings, wrapped, since a label is cut off at the width of its panel."""
    column = layout.column(align=True)
    column.scale_y = 0.8
    for line in lines:
        for number, part in enumerate(textwrap.wrap(line, width)):
            column.label(text=part, icon="BLANK1" if number else "ERROR")


def _of_object(obj, as_shown):
    """Warnings of what the numbers and the place of the result do not know."""
    found = []
    if not as_shown and surface.is_changed(obj):
        found.append(f"The result lies on the mesh of {obj.name} without its modifiers and shape keys.")
    scales = np.linalg.svd(np.array(obj.matrix_world)[:3, :3], compute_uv=False)
    if scales[0] - scales[-1] > 1e-4 * scales[0]:
        found.append("The object is scaled unevenly; lengths are those of the unscaled mesh (Ctrl A "
                     "applies the scale).")
    return found


def _is_measured(warning, drawing):
    """Whether the drawing itself has told, where it mattered, how far it was from the mesh."""
    return bool(drawing.names) and "moved onto the mesh" in warning


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
    "thickness": bpy.props.FloatProperty(
        name="Thickness", default=1, min=0, soft_max=4, precision=2, step=10,
        description="Of the curve object; 1 fits the edges and the size of the mesh"),
    "warned": bpy.props.StringProperty(options={"HIDDEN", "SKIP_SAVE"}),
    "mean_edge": bpy.props.FloatProperty(options={"HIDDEN", "SKIP_SAVE"}),
}


_STROKES = {
    "strokes": bpy.props.StringProperty(
        name="Strokes", default="",
        description="Numbers of the strokes to smooth, such as 0, 2-4; -1 is the last; empty: all"),
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
        return self.smooth(context, obj, lambda _: drawings.selected_edges(obj.data), False)


class TALWEG_OT_smooth_annotations(_Smoothing, bpy.types.Operator):
    """Smooth the strokes of the active annotation layer on the active mesh"""

    bl_idname = "talweg.smooth_annotations"
    bl_label = "Smooth Annotations"

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.mode == "OBJECT" \
            and context.object.type == "MESH"

    def execute(self, context):
        return self.smooth(context, context.object, lambda place: strokes.annotated(
            context, context.object, place, self.closed, self.thin, self.strokes),
            self.output == "CURVE")


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
