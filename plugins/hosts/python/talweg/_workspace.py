"""Workspaces: curves on a mesh, with values of parameters."""

from __future__ import annotations

import copy
import difflib
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Union

from . import _plugins
from ._curves import Curve, CurveLike, as_curves
from ._errors import BadUsage
from ._interruptible import as_progress
from ._results import Result

if TYPE_CHECKING:
    from ._mesh import Mesh

#: A number for all curves, or a list with a number for each; None in a list: the number for all.
OneOrEach = Union[float, Sequence[Optional[float]]]

#: Parameters of talweg.smooth for all curves, with the parameters for single curves.
_EACH_CURVE = {"tau": "taus", "slack": "slacks", "finish": "finishes"}


def _number_of(name: str, value: Any, choices: Sequence[str]) -> float:
    """A value in a list as a number of the parameter for single curves: a choice becomes its index, None
    becomes -1."""
    if value is None:
        return -1.0
    if choices:
        if value not in choices:
            raise BadUsage(f"{name} must be a list of {', '.join(choices)}, not of {value!r}.")
        return float(choices.index(value))
    try:
        return float(value)
    except (TypeError, ValueError):
        raise BadUsage(f"{name} must be a list of numbers, not of {value!r}.") from None


class Workspace:
    """Curves on a mesh and values of parameters: each run repeats only work whose input has changed.

    >>> work = talweg.Mesh(vertices, faces).workspace(drawn)
    >>> for tau in (0, 1, 2):
    ...     result = work.smooth(tau)     # repeats only work that depends on tau

    New curves repeat the stages that depend on them; ``tau`` and most parameters only the run. A workspace
    allows one call at a time; several workspaces on one mesh may run at the same time on different threads.
    """

    def __init__(self, mesh: Mesh, curves: Union[CurveLike, Sequence[Curve], None] = None, *,
                 closed: bool = False, plugin: str = "talweg.smooth", progress: Any = None,
                 **parameters: Any) -> None:
        self.mesh = mesh
        self._instance = mesh._instance(plugin)
        self._values: Dict[str, Any] = {}
        self._drawn: List[Curve] = []
        self.set(**parameters)
        if curves is not None:
            self.set_curves(curves, closed=closed, progress=progress)

    def __getstate__(self) -> Dict[str, Any]:
        return {"mesh": self.mesh, "plugin": self.plugin.id, "values": self._values,
                "drawn": self._drawn}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__init__(state["mesh"], plugin=state["plugin"])  # type: ignore[misc]
        for name, value in state["values"].items():
            self._instance.set(self.plugin.parameters[name], value)
        self._values = dict(state["values"])
        if state["drawn"]:
            self.set_curves(state["drawn"])

    @property
    def plugin(self) -> _plugins.Plugin:
        """The plugin of this workspace, with its description."""
        return self._instance.plugin

    @property
    def parameters(self) -> Dict[str, Any]:
        """The values of all parameters by name; None for parameters without a value."""
        defaults = {p.id: p.default for p in self.plugin.parameters.values()}
        return {**defaults, **self._values}

    def set_curves(self, curves: Union[CurveLike, Sequence[Curve]], *, closed: bool = False,
                   progress: Any = None) -> None:
        """Replaces the curves: a list of Curve, or one curve as for talweg.smooth().

        :raises BadCurve: if a curve does not lie on the mesh, or is invalid; the earlier curves stay then.
        """
        drawn = as_curves(curves, closed)
        self._instance.set_curves(drawn, as_progress(progress))
        self._drawn = copy.deepcopy(drawn)  # results contain the given curves, which the caller may change
                                            # later

    def set(self, **parameters: Any) -> None:
        """Sets parameters; None resets a parameter to its default.

        ``tau``, ``slack`` and ``finish`` may be lists with a value for each curve; None in a list: the value
        for all curves.

        :raises BadUsage: for a name that the plugin does not have, or a value out of range; the old value
            stays then.
        """
        for name in parameters:
            self._check_name(name)
        for name, value in self._each_curve(parameters).items():
            self._instance.set(self.plugin.parameters[name], value)
            self._values.pop(name, None)
            if value is not None:
                self._values[name] = value

    def _each_curve(self, parameters: Dict[str, Any]) -> Dict[str, Any]:
        """Moves lists to the parameters for single curves. A single value clears the list of an earlier call,
        unless the same call also gives the list."""
        result: Dict[str, Any] = {}
        for name, value in parameters.items():
            each = _EACH_CURVE.get(name)
            if each not in self.plugin.parameters:
                result[name] = value
            elif isinstance(value, (list, tuple)) or getattr(value, "ndim", 0) > 0:
                choices = self.plugin.parameters[name].choices
                result[each] = [_number_of(name, v, choices) for v in value]
            else:
                result[name] = value
                if each in self._values and each not in parameters:
                    result[each] = None
        return result

    def _check_name(self, name: str) -> None:
        names: List[str] = list(self.plugin.parameters)
        if name in names:
            return
        close = difflib.get_close_matches(name, names, n=1)
        hint = f" Did you mean {close[0]}?" if close else ""
        raise BadUsage(f"{self.plugin.id} has no parameter {name}.{hint} It has "
                       f"{', '.join(names)}.")

    def run(self, *, point_fields: bool = False, vertex_fields: bool = False, meshes: bool = False,
            carry: Optional[Mapping[str, str]] = None, progress: Any = None) -> Result:
        """Does all work whose input has changed, and returns the result.

        :param point_fields: also ``curve.fields``: "deviation" and "curvature" of every point.
        :param vertex_fields: also ``result.fields``: "distance" of every vertex.
        :param meshes: also ``result.meshes``, the meshes that the plugin makes, with interpolated attributes.
        :param carry: rules for the attributes, as for talweg.cut().
        :param progress: a function (stage, fraction in [0, 1]), called on this thread, that may return False
            to cancel; or a tqdm bar. Its exceptions are raised by run().
        :raises Cancelled: if ``progress`` returned False, or cancel() was called.
        :raises KeyboardInterrupt: soon after Ctrl-C; the workspace stays usable.
        :raises Error: BadCurve, BadUsage, ...: the sentence says what is wrong, and where.
        """
        call = as_progress(progress)
        if meshes:
            from ._made import run  # pylint: disable=import-outside-toplevel,cyclic-import

            result = run(self.mesh, self._instance, carry, (point_fields, vertex_fields), call)
        else:
            result = self._instance.run(point_fields, vertex_fields, call)
        return replace(result, drawn=self._drawn, mesh=self.mesh._as_closed())

    def smooth(self, tau: Optional[OneOrEach] = None, *, point_fields: bool = False,
               vertex_fields: bool = False, progress: Any = None, **parameters: Any) -> Result:
        """set(tau=tau, **parameters) and run(). tau=None: tau stays."""
        if tau is not None:
            parameters["tau"] = tau
        self.set(**parameters)
        return self.run(point_fields=point_fields, vertex_fields=vertex_fields, progress=progress)

    def cancel(self) -> None:
        """From any thread: the current run ends soon, with Cancelled."""
        self._instance.cancel()
