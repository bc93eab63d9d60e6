"""Sentences about a result for the user."""

import math

import numpy as np

from . import lengths, session

#: Radians: turning of a straight line by rounding errors alone, which is shown as 0.
_ROUNDING = 1e-9


def of_report(context, values):
    """The numbers in one sentence.

    :param values: values of the report by name.
    """
    shown = {name: lengths.number(values[name]) if abs(values[name]) > _ROUNDING else "0"
             for name in ("curvature_before", "curvature_after", "bending_before", "bending_after")}
    return (f"Curvature {shown['curvature_before']} to {shown['curvature_after']} rad, "
            f"bending {shown['bending_before']} to {shown['bending_after']}, "
            f"{math.degrees(values['window_turning_after']):.0f} degrees in one edge, "
            f"{_apart(context, values)} from the drawing, either way.")


def _apart(context, values):
    """The distance between result and drawing as a text. Curve objects of older versions have only the
    distance from the result to the drawing."""
    least = values.get("farthest", values["deviation_to_drawn_max"])
    most = values.get("farthest_at_most", least)
    bound = f"no farther than {lengths.with_unit(context, most)}"
    return bound if math.isfinite(most) else f"at least {lengths.with_unit(context, least)}"


def decisive_of(values):
    """The decisive warnings of a report, by which the result may be of no use."""
    return list(values.get("decisive", ()))


def others_of(values):
    """The warnings of a report that are not decisive."""
    decisive = decisive_of(values)
    return [one for one in values.get("warnings", ()) if one not in decisive]


def warnings_of(values):
    """All warnings of a report, the decisive ones first."""
    return decisive_of(values) + others_of(values)


def of_result(context, result):
    """The numbers of a result in one sentence."""
    return of_report(context, vars(result.total))


def of_object(obj, as_shown):
    """Warnings about modifiers and scales of the object, which the numbers of a result leave out."""
    found = []
    if not as_shown and session.is_changed(obj):
        found.append(f"The result lies on the mesh of {obj.name} without its modifiers and shape keys.")
    scales = _scales(obj)
    if scales[0] - scales[-1] > 1e-4 * scales[0]:
        found.append("The object is scaled unevenly; lengths are those of the unscaled mesh (Ctrl A "
                     "applies the scale).")
    return found


def of_scale(obj):
    """A note for the panel if a uniform scale makes the lengths differ from lengths in the scene."""
    scales = _scales(obj)
    if abs(scales[0] - 1) > 1e-4 and scales[0] - scales[-1] <= 1e-4 * scales[0]:
        return [f"Lengths are without the object's scale, {scales[0]:.4g}."]
    return []


def _scales(obj):
    """The singular values of the world matrix, descending: scales with those of parents, mirrors without
    their sign."""
    return np.linalg.svd(np.array(obj.matrix_world)[:3, :3], compute_uv=False)
