"""Properties of an operator, made from the plugin's description of its parameters."""

import math

import bpy

from .package import talweg

#: The parameters in the order of the panel. The rest of the add-on knows only their names.
SHOWN = ("tau", "slack", "max_deviation", "taus", "slacks", "ridges", "ridge_kind", "ends", "click_distance",
         "potential", "relax")


#: Shorter words for labels of the plugin that do not fit into the panel or name a page that Blender does not
#: show.
_LABELS = {"relax": "Relaxation", "taus": "Taus", "slacks": "Slacks"}
_CHOICES = {"corridor": ("Corridor", "Flat within the slack, then the exact distance along the surface"),
            "paper": ("Paper", "The published potential of the approximate distance, without a slack"),
            "auto": ("If They Meet", "A stroke whose end stops a little short of its beginning, or "
                     "runs over it, is a loop"),
            "closed": ("Loops", "Every curve is a loop"),
            "open": ("Open", "Only curves that are closed already are loops"),
            "both": ("Both", "Ridges and valleys"),
            "convex": ("Ridges", "Edges and crests, which stand out"),
            "concave": ("Valleys", "Creases and fissures")}

_CHOICE_TEXTS = {"potential": "The potential that keeps the curve close to the drawing",
                 "ends": "Which open curves become loops",
                 "ridge_kind": "The kind of ridges that attract the drawing, if the strength is above 0"}

#: Parameters that are lengths. Each also has a slider in mean edges, which suits meshes of every size.
_LENGTHS = ("slack", "max_deviation", "click_distance")


def described():
    return [talweg.plugin("talweg.smooth").parameters[name] for name in SHOWN]


def _start(parameter):
    """The default; without one, the number that the field shows before a result provides another."""
    if parameter.default is not None:
        return parameter.default
    return parameter.soft_minimum + (parameter.soft_maximum - parameter.soft_minimum) / 10


def _number(parameter, update):
    low = math.nextafter(parameter.minimum, math.inf) if parameter.open_minimum \
        else parameter.minimum
    start = _start(parameter)
    limits = {"min": max(low, -1e30), "max": min(parameter.maximum, 1e30),
              "soft_min": parameter.soft_minimum, "soft_max": parameter.soft_maximum}
    text = parameter.doc.rstrip(".") + (f" ({parameter.unit})" if parameter.unit else "")
    if parameter.kind == "integer":
        return bpy.props.IntProperty(name=_label(parameter), description=text, default=int(start),
                                     **{k: int(min(v, 2**31 - 1)) for k, v in limits.items()}, **update)
    if parameter.id in _LENGTHS:
        limits["soft_max"] = 1e30  # no upper limit, since the mesh may have any size
        limits["unit"] = "LENGTH"
    return bpy.props.FloatProperty(name=_label(parameter), description=text, default=start,
                                   precision=3, step=10, **limits, **update)


def _label(parameter):
    return _LABELS.get(parameter.id, parameter.label)


def _in_mean_edges(parameter):
    """A second property for a length, in mean edges."""
    def get(operator):
        return getattr(operator, parameter.id) / (operator.mean_edge or 1)

    def set(operator, value):
        setattr(operator, parameter.id, value * (operator.mean_edge or 1))

    return bpy.props.FloatProperty(
        name="In mean edges", description=f"{parameter.label} in mean edges of the mesh",
        min=1e-6, soft_min=0, soft_max=10, precision=3, get=get, set=set, options={"SKIP_SAVE"})


def _text(parameter, update):
    """A property for a list of numbers, one for each curve: a text, since the number of curves is not known
    in advance."""
    unit = f" ({parameter.unit})" if parameter.unit else ""
    text = parameter.doc.rstrip(".") + f"{unit}. Separated by spaces or commas, empty: none"
    return bpy.props.StringProperty(name=_label(parameter), description=text, default="", **update)


def _numbers(parameter, text):
    """The numbers in the text; None if it is empty; raises talweg.BadUsage."""
    result = []
    for word in text.replace(",", " ").replace(";", " ").split():
        try:
            result.append(float(word))
        except ValueError:
            raise talweg.BadUsage(f"{parameter.label}: '{word}' is not a number.") from None
    return result or None


def annotations(changed=None):
    """Annotations for a class of properties: one for each parameter, with use_NAME before an optional one.

    :param changed: the update function of the properties.
    """
    result, update = {}, {"update": changed} if changed else {}
    for parameter in described():
        if parameter.optional:
            result["use_" + parameter.id] = bpy.props.BoolProperty(
                name="Set " + parameter.label.lower(), default=False,
                description=parameter.doc.rstrip("."), **update)
        if parameter.kind == "choice":
            items = [(id, *_CHOICES.get(id, (label, ""))) for id, label in
                     zip(parameter.choices, parameter.choice_labels)]
            result[parameter.id] = bpy.props.EnumProperty(
                name=parameter.label, items=items, default=parameter.default,
                description=_CHOICE_TEXTS[parameter.id], **update)
        elif parameter.kind == "per_curve":
            result[parameter.id] = _text(parameter, update)
        else:
            result[parameter.id] = _number(parameter, update)
    for parameter in described():
        if parameter.id in _LENGTHS:
            result[parameter.id + "_in_edges"] = _in_mean_edges(parameter)
            result["shown_" + parameter.id] = bpy.props.FloatProperty(
                default=_start(parameter), options={"HIDDEN"})
    return result


def _value(operator, parameter):
    if parameter.optional and not getattr(operator, "use_" + parameter.id):
        return None
    value = getattr(operator, parameter.id)
    return _numbers(parameter, value) if parameter.kind == "per_curve" else value


def values(operator):
    """The values of an operator or of a curve object's settings by name; None for an optional parameter that
    is not used.

    :raises talweg.BadUsage: if a list of numbers cannot be read.
    """
    return {p.id: _value(operator, p) for p in described()}


def show_used(operator, report=None):
    """Sets the lengths that are not in use to the values that the result used or reached, or to a mean edge
    if those are 0 or infinite. Lengths that the user typed stay."""
    used = {"slack": report.slack, "max_deviation": report.farthest} if report else {}
    for id in _LENGTHS:
        value = used.get(id) or operator.mean_edge
        typed = getattr(operator, id) != getattr(operator, "shown_" + id)
        if getattr(operator, "use_" + id) or typed or not 0 < value < 1e30:
            continue
        setattr(operator, id, value)
        setattr(operator, "shown_" + id, value)


def draw(layout, operator):
    """Draws the fields. An optional parameter has a row of its own for its check box, so that its whole name
    fits."""
    for parameter in described():
        if not parameter.optional:
            layout.prop(operator, parameter.id)
            continue
        is_used = getattr(operator, "use_" + parameter.id)
        column = layout.column(align=True)
        column.use_property_split = False
        column.prop(operator, "use_" + parameter.id, text=parameter.label)
        field = column.row(align=True)
        field.active = is_used
        field.prop(operator, parameter.id, text="")
        if is_used and parameter.id in _LENGTHS:
            column.prop(operator, parameter.id + "_in_edges", slider=True)


def copy(source, target):
    """Copies all values from one class of properties to another."""
    for name in annotations():
        if not name.endswith("_in_edges"):
            setattr(target, name, getattr(source, name))
