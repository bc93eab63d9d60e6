"""Which steps of a repair are taken when a mesh is opened."""

from __future__ import annotations

from typing import TYPE_CHECKING, Dict, Union

from ._errors import BadUsage

if TYPE_CHECKING:
    from ._instance import Instance

STEPS = ("weld", "drop", "orient", "split")


def checked(repair: Union[None, bool, str]) -> Union[bool, str]:
    """False, True for all steps, or their names separated by commas.

    :raises BadUsage: for anything else.
    """
    if repair is None or isinstance(repair, bool):
        return bool(repair)
    names = [name.strip() for name in repair.split(",")] if isinstance(repair, str) else []
    if names == ["all"]:
        return True
    if not names or not set(names) <= set(STEPS):
        raise BadUsage(f"repair must be True, False or some of {', '.join(STEPS)}, separated by "
                       f"commas, not {repair!r}.")
    return ",".join(name for name in STEPS if name in names)


def values(repair: Union[bool, str]) -> Dict[str, bool]:
    """Parameters of plugins for what checked() gives."""
    chosen = repair.split(",") if isinstance(repair, str) else STEPS
    return {"repair": bool(repair), **{"repair_" + step: step in chosen for step in STEPS}}


def put(instance: Instance, repair: Union[bool, str]) -> None:
    """Before the mesh is set or shared. Nothing is asked of plugins where nothing is repaired."""
    parameters = instance.plugin.parameters
    if not repair:
        return
    if "repair" not in parameters:
        raise BadUsage(f"{instance.plugin.id} cannot repair a mesh; talweg.repair() makes one that "
                       "needs no repair.")
    for name, value in values(repair).items():
        instance.set(parameters[name], value)
