"""What is said of a result."""

import math

import bpy
import numpy as np

from . import session


def length(context, value):
    """In the units of the scene, if it has some."""
    units = context.scene.unit_settings
    if units.system == "NONE":
        return f"{value:.3g}"
    return bpy.utils.units.to_string(units.system, "LENGTH", value * units.scale_length, precision=3)


def of_result(context, result):
    """The numbers in one sentence."""
    r = result.total
    return (f"Curvature {r.curvature_before:.3g} to {r.curvature_after:.3g} rad, "
            f"bending {r.bending_before:.3g} to {r.bending_after:.3g}, "
            f"{math.degrees(r.window_turning_after):.0f} degrees in one edge, no farther than "
            f"{length(context, r.deviation_to_drawn_max)} from the drawing.")


def of_object(obj, as_shown):
    """Warnings of what the numbers and the place of the result do not know."""
    found = []
    if not as_shown and session.is_changed(obj):
        found.append(f"The result lies on the mesh of {obj.name} without its modifiers and shape keys.")
    scales = _scales(obj)
    if scales[0] - scales[-1] > 1e-4 * scales[0]:
        found.append("The object is scaled unevenly; lengths are those of the unscaled mesh (Ctrl A "
                     "applies the scale).")
    return found


def of_scale(obj):
    """A note for the panel, where an even scale makes lengths others than those of the scene."""
    scales = _scales(obj)
    if abs(scales[0] - 1) > 1e-4 and scales[0] - scales[-1] <= 1e-4 * scales[0]:
        return [f"Lengths are without the object's scale, {scales[0]:.4g}."]
    return []


def _scales(obj):
    """Of the world matrix, descending; mirrors count as 1, parents count."""
    return np.linalg.svd(np.array(obj.matrix_world)[:3, :3], compute_uv=False)
