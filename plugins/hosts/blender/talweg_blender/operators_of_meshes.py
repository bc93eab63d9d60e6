"""Operators that cut along curve objects, separate, smooth borders of materials and vertex groups, and
repair."""

import bpy

from . import cutting, drawings, long_operator, repair_offers, session
from .naming import named
from .package import talweg

#: Mean edges: a point so near to an edge is on the edge. Curve objects store points in single precision.
_MERGE = 1e-5


#: Shorter words for the plugin's labels that do not fit into the panel.
_LABELS = {"ends": "Ends"}
_CHOICES = {"fixed": "Stay", "free": "Move", "slide": "Slide", "auto": "Automatic",
            "left": "Left", "right": "Right"}


def choice(plugin, name):
    """A property for a parameter of a plugin that is a choice."""
    parameter = talweg.plugin(plugin).parameters[name]
    return bpy.props.EnumProperty(
        name=_LABELS.get(name, parameter.label), default=parameter.default,
        description=f"{parameter.label}. {parameter.doc}".rstrip("."),
        items=[(id, _CHOICES.get(id, label), label) for id, label in
               zip(parameter.choices, parameter.choice_labels)])


def number(plugin, name, default, low, high, **more):
    """A property for a parameter of a plugin that is a number."""
    parameter = talweg.plugin(plugin).parameters[name]
    return bpy.props.FloatProperty(name=parameter.label, description=parameter.doc.rstrip("."),
                                   default=default, min=low, soft_max=high, precision=3, step=10, **more)


def counted(count, word):
    """The number with its noun, in the singular or plural."""
    return f"{count} {word}" + ("" if count == 1 else "s")


class _OnMesh(long_operator.LongOperator):
    """Base of the operators on the active mesh in object mode."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.mode == "OBJECT" \
            and context.object.type == "MESH"

    def subject(self, context):
        return context.object

    def draw(self, _context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        for name in type(self).__annotations__:
            self.layout.prop(self, name)


def _drawing(context, obj):
    """The Drawing of the selected curve objects, the arrays of the mesh, and the options of the cut. Points
    that were rounded to single precision are merged with edges."""
    place = session.surface_of(context, obj, as_shown=False)
    drawing = drawings.curve_objects(context, obj, place, place.known_curves())
    exact = all(curve.faces is not None for curve in drawing.curves)
    return drawing, place.arrays, {} if exact else {"merge": _MERGE}


class TALWEG_OT_cut(_OnMesh, bpy.types.Operator):
    """Make selected curve objects edges of the active mesh; the mesh keeps all its data"""

    bl_idname = "talweg.cut"
    bl_label = "Cut Along Curve"

    def steps(self, context, obj):
        drawing, arrays, how = _drawing(context, obj)
        with named(drawing.names):
            made, warnings = yield from cutting.cut(obj, arrays, drawing.curves, open=self.open, **how)
        context.tool_settings.mesh_select_mode = (False, True, False)
        return (counted(made.report["cut_faces"], "face") + " cut.",
                [*drawing.warnings, *warnings, *cutting.of_report(made)])


class TALWEG_OT_separate(_OnMesh, bpy.types.Operator):
    """Take the active mesh apart along selected curve objects: an object for each piece"""

    bl_idname = "talweg.separate"
    bl_label = "Separate Along Curve"

    def steps(self, context, obj):
        drawing, arrays, how = _drawing(context, obj)
        with named(drawing.names):
            pieces, warnings = yield from cutting.separate(obj, arrays, drawing.curves, keep=self.keep,
                                                           cap=self.cap, **how)
        return (f"{counted(len(pieces), 'object')}: {', '.join(one.name for one in pieces)}.",
                [*drawing.warnings, *warnings])


class _Borders(_OnMesh):
    def steps(self, _context, obj):
        found, warnings = yield from self.smoothed(obj, drawings.MeshArrays(obj.data), **self.values())
        return counted(len(found.borders), "border") + ".", [*warnings, *found.report["warnings"]]

    def values(self):
        how = {"tau": self.tau, "junctions": self.junctions, "ends": self.ends}
        if self.max_deviation > 0:
            how["max_deviation"] = self.max_deviation
        return how


class TALWEG_OT_material_borders(_Borders, bpy.types.Operator):
    """Smooth all borders between materials together, and cut them into the mesh"""

    bl_idname = "talweg.material_borders"
    bl_label = "Smooth Material Borders"

    smoothed = staticmethod(cutting.smooth_materials)


class TALWEG_OT_group_borders(_Borders, bpy.types.Operator):
    """Smooth the border of the active vertex group, and cut it into the mesh"""

    bl_idname = "talweg.group_borders"
    bl_label = "Smooth Vertex-Group Borders"

    def smoothed(self, obj, arrays, **how):
        return cutting.smooth_group(obj, arrays, self.threshold, **how)


class TALWEG_OT_repair(_OnMesh, bpy.types.Operator):
    """Repair the mesh to a surface that curves can lie on: weld, drop, orient and split"""

    bl_idname = "talweg.repair"
    bl_label = "Repair for Talweg"

    @classmethod
    def poll(cls, context):
        """The repair also works in edit mode, where the smoothing operators refuse unsound meshes."""
        return context.object is not None and context.object.mode in ("OBJECT", "EDIT") \
            and context.object.type == "MESH"

    def steps(self, _context, obj):
        steps = [name for name in ("weld", "drop", "orient", "split") if getattr(self, name)]
        if not steps:
            raise talweg.BadUsage("No step of the repair is chosen.")
        if self.weld and self.weld_within > 0:
            steps[0] = f"weld={self.weld_within!r}"
        obj.update_from_editmode()
        fixed, warnings = yield from cutting.repair(obj, drawings.MeshArrays(obj.data),
                                                   ",".join(steps))
        repair_offers.forget(obj)
        return " ".join(fixed.changes) or "The mesh needs no repair.", warnings


CLASSES = (TALWEG_OT_cut, TALWEG_OT_separate, TALWEG_OT_material_borders, TALWEG_OT_group_borders,
           TALWEG_OT_repair)


def _properties():
    borders = {"tau": number("talweg.labels", "tau", 1, 0, 16),
               "max_deviation": number("talweg.labels", "max_deviation", 0, 0, 1e30, unit="LENGTH"),
               "junctions": choice("talweg.labels", "junctions"),
               "ends": choice("talweg.labels", "ends")}
    threshold = bpy.props.FloatProperty(name="Inside from", default=0.5, min=0, max=1, precision=3,
                                        description="Vertices of this weight or more are inside")
    steps = {name: bpy.props.BoolProperty(
        name=name.capitalize(), default=True,
        description=talweg.plugin("talweg.repair").parameters["repair_" + name].doc.rstrip("."))
        for name in ("weld", "drop", "orient", "split")}
    within = talweg.plugin("talweg.repair").parameters["repair_weld_tolerance"]
    steps["weld_within"] = bpy.props.FloatProperty(
        name="Weld within", default=0, min=0, precision=6, step=0.01, unit="LENGTH",
        description=within.doc.rstrip("."))
    opened = talweg.plugin("talweg.cut").parameters["open"]
    return {TALWEG_OT_cut: {"open": bpy.props.BoolProperty(
                name=opened.label, default=False, description=opened.doc.rstrip("."))},
            TALWEG_OT_separate: {name: choice("talweg.cut", name) for name in ("keep", "cap")},
            TALWEG_OT_material_borders: borders,
            TALWEG_OT_group_borders: {"threshold": threshold, **borders}, TALWEG_OT_repair: steps}


def register():
    for cls, properties in _properties().items():
        cls.__annotations__ = properties
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
