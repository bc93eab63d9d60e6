"""Properties of an operator from the plugin's own description of its parameters."""

import math

import bpy

from .package import talweg

#: In the order of the panel; of these the rest of the add-on knows nothing but the names.
SHOWN = ("tau", "slack", "max_deviation", "taus", "slacks", "potential", "relax")


def described():
    return [talweg.plugin("talweg.smooth").parameters[name] for name in SHOWN]


def _number(parameter):
    low = math.nextafter(parameter.minimum, math.inf) if parameter.open_minimum \
        else parameter.minimum
    start = parameter.default
    if start is None:  # what the slider shows until it is moved
        start = parameter.soft_minimum + (parameter.soft_maximum - parameter.soft_minimum) / 10
    limits = {"min": max(low, -1e30), "max": min(parameter.maximum, 1e30),
              "soft_min": parameter.soft_minimum, "soft_max": parameter.soft_maximum}
    text = parameter.doc.rstrip(".") + (f" ({parameter.unit})" if parameter.unit else "")
    if parameter.kind == "integer":
        return bpy.props.IntProperty(name=parameter.label, description=text, default=int(start),
                                     **{k: int(min(v, 2**31 - 1)) for k, v in limits.items()})
    return bpy.props.FloatProperty(name=parameter.label, description=text, default=start,
                                   precision=4, step=10, **limits)


def _text(parameter):
    """One number for each curve is a text, since how many curves there are is not known before."""
    unit = f" ({parameter.unit})" if parameter.unit else ""
    text = parameter.doc.rstrip(".") + f"{unit}. Separated by spaces or commas, empty: none"
    return bpy.props.StringProperty(name=parameter.label, description=text, default="")


def _numbers(parameter, text):
    """None if there are none, else as many as were typed; raises talweg.BadUsage."""
    result = []
    for word in text.replace(",", " ").replace(";", " ").split():
        try:
            result.append(float(word))
        except ValueError:
            raise talweg.BadUsage(f"{parameter.label}: '{word}' is no number.") from None
    return result or None


def annotations():
    """Of an operator's class: each parameter's property, and use_NAME before an optional one."""
    result = {}
    for parameter in described():
        if parameter.optional:
            result["use_" + parameter.id] = bpy.props.BoolProperty(
                name="Set " + parameter.label.lower(), default=False,
                description=parameter.doc.rstrip("."))
        if parameter.kind == "choice":
            items = [(id, label, "") for id, label in
                     zip(parameter.choices, parameter.choice_labels)]
            result[parameter.id] = bpy.props.EnumProperty(
                name=parameter.label, items=items, default=parameter.default,
                description=parameter.doc.rstrip("."))
        elif parameter.kind == "per_curve":
            result[parameter.id] = _text(parameter)
        else:
            result[parameter.id] = _number(parameter)
    return result


def _value(operator, parameter):
    if parameter.optional and not getattr(operator, "use_" + parameter.id):
        return None
    value = getattr(operator, parameter.id)
    return _numbers(parameter, value) if parameter.kind == "per_curve" else value


def values(operator):
    """Of an operator: None for a parameter that is not to be used; raises talweg.BadUsage."""
    return {p.id: _value(operator, p) for p in described()}


def show_used(operator, report):
    """Optional parameters that are not ticked show what was used or reached, to begin from."""
    for id, value in (("slack", report.slack), ("max_deviation", report.deviation_to_drawn_max)):
        if not getattr(operator, "use_" + id) and value is not None and 0 < value < 1e30:
            setattr(operator, id, value)


def draw(layout, operator):
    """The redo panel."""
    for parameter in described():
        if parameter.optional:
            row = layout.row(heading=parameter.label)
            row.prop(operator, "use_" + parameter.id, text="")
            field = row.row()
            field.active = getattr(operator, "use_" + parameter.id)
            field.prop(operator, parameter.id, text="")
        else:
            layout.prop(operator, parameter.id)
