"""Lengths as they are told."""

import bpy


def told(context, value):
    """In the units of the scene, if it has some."""
    units = context.scene.unit_settings
    if units.system == "NONE":
        return f"{value:.3g}"
    return bpy.utils.units.to_string(units.system, "LENGTH", value * units.scale_length, precision=3)
