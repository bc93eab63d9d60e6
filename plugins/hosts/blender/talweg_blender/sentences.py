"""What is said of a result."""

import math

import numpy as np

from . import lengths, session

#: Radians: a straight line turns by no more, and that is not worth a number.
_ROUNDING = 1e-9


def of_report(context, values):
    """The numbers in one sentence.

    :param values: by the names of the report.
    """
    shown = {name: lengths.number(values[name]) if abs(values[name]) > _ROUNDING else "0"
             for name in ("curvature_before", "curvature_after", "bending_before", "bending_after")}
    return (f"Curvature {shown['curvature_before']} to {shown['curvature_after']} rad, "
            f"bending {shown['bending_before']} to {shown['bending_after']}, "
            f"{math.degrees(values['window_turning_after']):.0f} degrees in one edge, "
            f"{_apart(context, values)} from the drawing, either way.")


def _apart(context, values):
    """How far result and drawing lie apart. Reports that an older add-on kept know it one way."""
    least = values.get("farthest", values["deviation_to_drawn_max"])
    most = values.get("farthest_at_most", least)
    bound = f"no farther than {lengths.told(context, most)}"
    return bound if math.isfinite(most) else f"at least {lengths.told(context, least)}"


def decisive_of(values):
    """Those of a report by which the result may be of no use."""
    return list(values.get("decisive", ()))


def others_of(values):
    """Its other warnings."""
    decisive = decisive_of(values)
    return [one for one in values.get("warnings", ()) if one not in decisive]


def warnings_of(values):
    """All of a report, those first by which the result may be of no use."""
    return decisive_of(values) + others_of(values)


def of_result(context, result):
    """The same of a result."""
    return of_report(context, vars(result.total))


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
