"""Smooths the drawing of a curve object again when a user changes one of its values. Only the curve object
changes; the mesh gets no undo step."""

import bpy

from . import colours, curve_object, lengths, long_operator, outcomes, parameters, sentences, session, settings
from . import wrapped
from .naming import named
from .package import talweg

#: Functions (context, curve) -> bool. A function returns True if it smooths the curve itself, as the drawing
#: tool does while it edits the curve.
others = []

_wrong = {}  # the error of the last value, by the name of the curve object


def smooth(context, curve, trust=True):
    """Smooths the drawing of a curve object and shows the result.

    :returns: the Surface and the talweg.Result.
    :raises talweg.Error: if the drawing or a value is refused.
    """
    kept, obj = settings.of(curve), curve.parent
    if kept.as_shown and session.is_changed(obj) and (obj.mode != "OBJECT" or not obj.visible_get()):
        raise talweg.BadUsage(f"{curve.name} lies on {obj.name} with its modifiers. Blender applies them "
                              f"only in object mode, and while {obj.name} is visible.")
    place = session.surface_of(context, obj, kept.as_shown, trust)
    drawn = settings.drawn_on(curve, place)
    with named([curve.name]):
        result = session.smooth(place, drawn, parameters.values(kept), repair=kept.repair,
                                key=curve["talweg_drawing"], **colours.wanted_fields(kept))
    with settings.quietly():
        parameters.show_used(kept, result.total)
    curve_object.write(curve, place, result)
    _wrong.pop(curve.name, None)
    return place, result


def _by_hand(context, curve):
    if not settings.is_kept(curve) or any(take(context, curve) for take in others):
        return
    try:
        smooth(context, curve)
    except talweg.Error as error:
        _wrong[curve.name] = str(error)


class TALWEG_OT_to_mesh(long_operator.LongOperator, bpy.types.Operator):
    """Make the selected curve object edges of its mesh, mark them, or take the mesh apart"""

    bl_idname = "talweg.to_mesh"
    bl_label = "Into the Mesh"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return settings.is_kept(context.object) and context.object.mode == "OBJECT" \
            and context.object.parent.mode == "OBJECT"

    def subject(self, context):
        return context.object.parent

    def steps(self, context, obj):
        curve = context.object
        outcomes.check(self.output, settings.of(curve).repair)
        if settings.of(curve).as_shown and session.is_changed(obj):
            raise talweg.BadUsage(f"{curve.name} lies on {obj.name} with its modifiers; apply them "
                                  "first, and smooth again.")
        place, result = smooth(context, curve, trust=False)
        message, warnings = yield from outcomes.of_mesh(context, obj, place, result, self.output)
        return message or "Cut.", warnings


def numbers(context, curve):
    """The numbers of the shown result as a sentence; empty before the first result."""
    values = curve_object.report_of(curve)
    return sentences.of_report(context, values) if values else ""


def icon(curve):
    """The icon of the curve's row: ERROR if its result may be of no use."""
    return "ERROR" if sentences.decisive_of(curve_object.report_of(curve)) else "CURVE_DATA"


def draw_decisive(layout, curve):
    """Draws the decisive warnings as a box. The sidebar has the box at its top, since buttons and fields may
    be higher than the sidebar."""
    lines = sentences.decisive_of(curve_object.report_of(curve))
    if lines and curve.name not in _wrong:
        box = layout.box()
        box.alert = True
        wrapped.draw(box, [f"{curve.name}: {lines[0]}", *lines[1:]])


def _colours(context, curve):
    """The legend of the colours: the values of the darkest and the brightest."""
    most = curve["talweg_range"]
    if settings.of(curve).colours == "DEVIATION":
        return f"Dark to bright: 0 to {lengths.with_unit(context, most)}"
    return f"Dark to bright: 0 to {most:.3g} rad for each unit of length"


def draw(layout, curve):
    """The panel of a curve object, below draw_decisive()."""
    kept = settings.of(curve)
    column = layout.column()
    column.use_property_split = True
    column.use_property_decorate = False
    parameters.draw(column, kept)
    wrapped.draw(column, sentences.of_scale(curve.parent), icon="INFO")
    settings.draw_own(column, kept)
    if kept.colours != "PLAIN" and "talweg_range" in curve:
        wrapped.draw(layout, [_colours(bpy.context, curve)], icon="COLOR")
    wrong = _wrong.get(curve.name)
    if wrong:
        wrapped.draw(layout, [wrong])
    else:
        wrapped.draw(layout, sentences.others_of(curve_object.report_of(curve)))
        wrapped.draw(layout, [numbers(bpy.context, curve)], icon="INFO")


def register():
    TALWEG_OT_to_mesh.__annotations__ = {"output": bpy.props.EnumProperty(
        name="Result", items=outcomes.ITEMS[1:], default="EDGES")}
    bpy.utils.register_class(TALWEG_OT_to_mesh)
    settings.changed_by_hand.append(_by_hand)


def unregister():
    settings.changed_by_hand.remove(_by_hand)
    bpy.utils.unregister_class(TALWEG_OT_to_mesh)
