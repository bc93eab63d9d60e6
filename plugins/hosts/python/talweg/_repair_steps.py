"""The steps of a repair when a mesh is opened."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Dict, List, Union

from ._errors import BadUsage

if TYPE_CHECKING:
    from ._instance import Instance

STEPS = ("weld", "drop", "orient", "split")
WITHIN = "weld="


def checked(repair: Union[None, bool, str]) -> Union[bool, str]:
    """A checked choice of steps: False for none, True for all, or their names separated by commas, with
    "weld=TOLERANCE" as another form of "weld".

    :raises BadUsage: for anything else.
    """
    if repair is None or isinstance(repair, bool):
        return bool(repair)
    names = [name.strip() for name in repair.split(",")] if isinstance(repair, str) else []
    if names == ["all"]:
        return True
    tolerances = [_tolerance(name) for name in names if name.startswith(WITHIN)]
    names = ["weld" if name.startswith(WITHIN) else name for name in names]
    if not names or not set(names) <= {"all", *STEPS}:
        raise BadUsage(f"repair must be True, False or some of {', '.join(STEPS)}, separated by "
                       f"commas, also weld=TOLERANCE, not {repair!r}.")
    chosen = [name for name in STEPS if name in names or "all" in names]
    if tolerances:
        chosen[0] = f"{WITHIN}{tolerances[-1]!r}"
    return ",".join(chosen)


def _tolerance(name: str) -> float:
    try:
        tolerance = float(name[len(WITHIN):])
    except ValueError:
        tolerance = math.nan
    if not 0 < tolerance < math.inf:
        raise BadUsage("The tolerance of weld must be a length above 0 in mesh units, as in "
                       f"weld=1e-4, not {name[len(WITHIN):]!r}.")
    return tolerance


def values(repair: Union[bool, str]) -> Dict[str, Any]:
    """The parameters of plugins for a choice from checked()."""
    chosen: List[str] = repair.split(",") if isinstance(repair, str) else list(STEPS)
    names = [step.split("=")[0] for step in chosen]
    result: Dict[str, Any] = {"repair": bool(repair)}
    result.update({"repair_" + step: step in names for step in STEPS})
    if chosen[0].startswith(WITHIN):
        result["repair_weld_tolerance"] = float(chosen[0][len(WITHIN):])
    return result


def put(instance: Instance, repair: Union[bool, str]) -> None:
    """Sets the steps on an instance, before its mesh is set or shared. Without a repair, plugins without such
    parameters are accepted."""
    parameters = instance.plugin.parameters
    if not repair:
        return
    if "repair" not in parameters:
        raise BadUsage(f"{instance.plugin.id} cannot repair a mesh; talweg.repair() makes one that "
                       "needs no repair.")
    for name, value in values(repair).items():
        instance.set(parameters[name], value)
