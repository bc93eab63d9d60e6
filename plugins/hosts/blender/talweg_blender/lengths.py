"""Numbers and lengths as they are told."""

import bpy


def number(value, digits=3):
    """As few people read 4.5e+02, larger numbers have all digits before the point."""
    is_large = 10 ** digits <= abs(value) + 0.5 < 1e9
    return f"{value:.0f}" if is_large else f"{value:.{digits}g}"


def told(context, value):
    """In the units of the scene, if it has some."""
    units = context.scene.unit_settings
    if units.system == "NONE":
        return number(value)
    return bpy.utils.units.to_string(units.system, "LENGTH", value * units.scale_length, precision=3)
