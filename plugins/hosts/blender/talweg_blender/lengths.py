"""Numbers and lengths as texts for the user."""

import bpy


def number(value, digits=3):
    """A number with ``digits`` significant digits; larger numbers have all digits before the point, since
    4.5e+02 is hard to read."""
    is_large = 10 ** digits <= abs(value) + 0.5 < 1e9
    return f"{value:.0f}" if is_large else f"{value:.{digits}g}"


def with_unit(context, value):
    """A length in the units of the scene, or as a plain number if the scene has none."""
    units = context.scene.unit_settings
    if units.system == "NONE":
        return number(value)
    return bpy.utils.units.to_string(units.system, "LENGTH", value * units.scale_length, precision=3)
