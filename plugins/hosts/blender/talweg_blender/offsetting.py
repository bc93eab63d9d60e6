"""Offset curves of selected curve objects at a distance along the surface, as a curve object."""

import bpy

from . import curve_object, drawings, lengths, long_operator, operators_of_meshes, session, settings
from .naming import named
from .package import talweg

#: The first distance, in mean edges of the mesh: a length in mesh units would not suit meshes of every size.
_FIRST = 3


def _line(context, result, distance, count, made):
    """The report of a result as a sentence."""
    many = f"{count} distances up to " if count > 1 else ""
    return (f"{operators_of_meshes.counted(len(result.curves), 'curve')} at {many}"
            f"{lengths.with_unit(context, count * distance)} along the surface, length "
            f"{lengths.with_unit(context, result.total.length)}: {made.name}.")


class TALWEG_OT_offset(long_operator.LongOperator, bpy.types.Operator):
    """Make curves at a distance from the selected curve objects, measured along the surface"""

    bl_idname = "talweg.offset"
    bl_label = "Offset Curve"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        """Whether the active object is a mesh, or a curve object on one."""
        obj = context.object
        return obj is not None and obj.mode == "OBJECT" and (obj.type == "MESH" or settings.is_kept(obj))

    def subject(self, context):
        return context.object if context.object.type == "MESH" else context.object.parent

    def steps(self, context, obj):
        place = session.surface_of(context, obj, as_shown=True)
        if not self.properties.is_property_set("distance"):
            self.distance = _FIRST * place.edge
        drawing = drawings.curve_objects(context, obj, place, place.known_curves())
        mesh = place.mesh()
        how = {"side": self.side, "caps": self.caps, "ends": self.ends, "count": self.count}
        with named(drawing.names):
            result = yield lambda progress: mesh.offset(drawing.curves, self.distance, progress=progress,
                                                        **how)
        made = curve_object.new(context, obj, "offset")
        curve_object.write_lines(made, place, result)
        place.know(made.name, result)
        warnings = [one for one in result.total.warnings if "moved onto the mesh" not in one]
        message = _line(context, result, self.distance, self.count, made)
        return message, [*drawing.warnings, *warnings]

    def draw(self, _context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        for name in type(self).__annotations__:
            self.layout.prop(self, name)


def register():
    count = talweg.plugin("talweg.offset").parameters["count"]
    TALWEG_OT_offset.__annotations__ = {
        "distance": operators_of_meshes.number("talweg.offset", "distance", 1, 1e-30, 1e30, unit="LENGTH"),
        "count": bpy.props.IntProperty(name=count.label, description=count.doc.rstrip("."), default=1, min=1,
                                       soft_max=10, max=10000),
        **{name: operators_of_meshes.choice("talweg.offset", name) for name in ("side", "caps", "ends")}}
    bpy.utils.register_class(TALWEG_OT_offset)


def unregister():
    bpy.utils.unregister_class(TALWEG_OT_offset)
