"""Meshes, opened once, and workspaces on them."""

from __future__ import annotations

import difflib
import threading
from typing import Any, Dict, List, Optional, Sequence, Union

import numpy as np

from . import _arrays, _plugins
from ._curves import ArrayLike, Curve, CurveLike, as_curve, as_curves
from ._errors import BadMesh, BadUsage
from ._instance import Instance
from ._interruptible import as_progress
from ._results import Distance, Result
from ._version import __version__


def _fans(cells: Any) -> np.ndarray:
    """Triangles of a meshio cell block; polygons become fans, as when Talweg reads a file."""
    corners = np.asarray(cells.data)
    middle = range(1, corners.shape[1] - 1)
    return np.stack([corners[:, [0, k, k + 1]] for k in middle], axis=1).reshape(-1, 3)


def _arrays_of(mesh: Any) -> Any:
    """Vertices and triangles of a trimesh or meshio object, or of whatever looks like one."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):
        polygons = [block for block in mesh.cells
                    if block.type in ("triangle", "quad", "polygon") and len(block.data) > 0]
        if not polygons:
            raise BadMesh("The mesh has no triangles, quads or polygons.")
        if len(polygons) == 1 and polygons[0].type == "triangle":
            return mesh.points, polygons[0].data
        return mesh.points, np.concatenate([_fans(block) for block in polygons])
    raise BadMesh("A mesh is given as vertices (n, 3) and faces (m, 3), or as an object with "
                  f"vertices and faces, or points and cells, not as {type(mesh).__name__}.")


#: A number for all curves, or one for each; None: as for all.
OneOrEach = Union[float, Sequence[Optional[float]]]

#: Parameters of talweg.smooth, and those that have a value of theirs for each curve.
_EACH_CURVE = {"tau": "taus", "slack": "slacks", "finish": "finishes"}


def _number_of(name: str, value: Any, choices: Sequence[str]) -> float:
    """As the parameter for each curve has it: a choice by its number, and -1 for none."""
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


class Mesh:
    """A triangle mesh, opened: checked and copied once, then shared by all that works on it.

    :param vertices: (n, 3) real numbers, float64 or float32, mesh units; or a trimesh, meshio or
        similar object, without ``faces``.
    :param faces: (m, 3) whole numbers, counterclockwise from outside.
    :raises BadMesh: if it is no oriented manifold; the sentence says where.

    The arrays are not copied on our side where the interface can read them as they are (any
    strides of rows; float32, float64; 32- and 64-bit integers). They are looked at again when
    another plugin is first used, so leave them unchanged. Any thread may use the mesh; a
    workspace belongs to one at a time.
    """

    def __init__(self, vertices: Any, faces: Optional[ArrayLike] = None, *, progress: Any = None,
                 plugin: str = "talweg.smooth") -> None:
        if faces is None:
            vertices, faces = _arrays_of(vertices)
        self.vertices = _arrays.readable(vertices, 3, "The mesh's vertices", BadMesh)
        self.faces = _arrays.readable(faces, 3, "The mesh's faces", BadMesh)
        self._owners: Dict[str, Instance] = {}
        self._opening = threading.Lock()
        self._instance(plugin, progress)

    def _instance(self, plugin: str, progress: Any = None) -> Instance:
        """A new instance of the plugin, with the mesh."""
        found = _plugins.plugin(plugin)
        with self._opening:
            if plugin not in self._owners:
                owner = Instance(found, __version__)
                owner.set_mesh(self.vertices, self.faces, as_progress(progress))
                self._owners[plugin] = owner
            instance = Instance(found, __version__)
            instance.share_mesh(self._owners[plugin])
        return instance

    def workspace(self, curves: Union[CurveLike, Sequence[Curve], None] = None, *,
                  closed: bool = False, plugin: str = "talweg.smooth",
                  **parameters: Any) -> "Workspace":
        """A workspace on this mesh; see Workspace."""
        return Workspace(self, curves, closed=closed, plugin=plugin, **parameters)

    def smooth(self, curve: Union[CurveLike, Sequence[Curve]], tau: OneOrEach = 1.0, *,
               closed: bool = False, point_fields: bool = False, vertex_fields: bool = False,
               progress: Any = None, **parameters: Any) -> Result:
        """talweg.smooth() on this mesh."""
        work = Workspace(self, curve, closed=closed, progress=progress)
        return work.smooth(tau, point_fields=point_fields, vertex_fields=vertex_fields,
                           progress=progress, **parameters)

    def draw(self, points: CurveLike, *, closed: bool = False, straight: bool = False,
             exact: bool = True) -> Curve:
        """talweg.draw() on this mesh."""
        work = Workspace(self, as_curve(points, closed), plugin="talweg.draw", straight=straight,
                         points="exact" if exact else "rough")
        return work.run().curve

    def geodesic(self, curve: Union[CurveLike, Sequence[Curve]], *, closed: bool = False,
                 point_fields: bool = False, progress: Any = None, **parameters: Any) -> Result:
        """talweg.geodesic() on this mesh."""
        work = Workspace(self, curve, closed=closed, plugin="talweg.geodesic", **parameters)
        return work.run(point_fields=point_fields, progress=progress)

    def distance(self, curve: Union[CurveLike, Sequence[Curve]], *, closed: bool = False,
                 progress: Any = None, **parameters: Any) -> Distance:
        """talweg.distance() on this mesh."""
        work = Workspace(self, curve, closed=closed, plugin="talweg.distance", **parameters)
        result = work.run(vertex_fields=True, progress=progress)
        total = result.total.more
        return Distance(result.fields["distance"], result.fields["potential"],
                        total["distance_max"], total["potential_max"],
                        tuple(report.slack for report in result.reports if report.slack is not None))


class Workspace:
    """Curves on a mesh and values of parameters: each run repeats only what has changed.

    >>> work = talweg.Mesh(vertices, faces).workspace(drawn)
    >>> for tau in (0, 1, 2):
    ...     result = work.smooth(tau)     # only what tau touches

    New curves cost what depends on them; ``tau`` and most parameters only the run. One call at a
    time; workspaces on one mesh may run at the same time on different threads.
    """

    def __init__(self, mesh: Mesh, curves: Union[CurveLike, Sequence[Curve], None] = None, *,
                 closed: bool = False, plugin: str = "talweg.smooth", progress: Any = None,
                 **parameters: Any) -> None:
        self.mesh = mesh
        self._instance = mesh._instance(plugin)
        self._values: Dict[str, Any] = {}
        self.set(**parameters)
        if curves is not None:
            self.set_curves(curves, closed=closed, progress=progress)

    @property
    def plugin(self) -> _plugins.Plugin:
        """What works here, and its description."""
        return self._instance.plugin

    @property
    def parameters(self) -> Dict[str, Any]:
        """The values of all parameters; None where there is none."""
        defaults = {p.id: p.default for p in self.plugin.parameters.values()}
        return {**defaults, **self._values}

    def set_curves(self, curves: Union[CurveLike, Sequence[Curve]], *, closed: bool = False,
                   progress: Any = None) -> None:
        """Replaces the curves: a list of Curve, or one curve as talweg.smooth() takes it.

        :raises BadCurve: if one is not on the mesh, or not properly; those before stay then.
        """
        self._instance.set_curves(as_curves(curves, closed), as_progress(progress))

    def set(self, **parameters: Any) -> None:
        """New values of parameters; None: back to the default.

        ``tau``, ``slack`` and ``finish`` may be lists with a value for each curve; None there: as
        for all.

        :raises BadUsage: for a name that the plugin does not have, or a value out of its range;
            the old value stays then.
        """
        for name in parameters:
            self._check_name(name)
        for name, value in self._each_curve(parameters).items():
            self._instance.set(self.plugin.parameters[name], value)
            self._values.pop(name, None)
            if value is not None:
                self._values[name] = value

    def _each_curve(self, parameters: Dict[str, Any]) -> Dict[str, Any]:
        """Lists go to the parameters for them, from which a single value takes them back unless
        they are given beside it."""
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

    def run(self, *, point_fields: bool = False, vertex_fields: bool = False,
            progress: Any = None) -> Result:
        """Does what is not up to date yet.

        :param point_fields: also ``curve.fields``: "deviation" and "curvature" of every point.
        :param vertex_fields: also ``result.fields``: "distance" of every vertex.
        :param progress: a function (stage, fraction in [0, 1]), called on this thread, that may
            return False to cancel; or a tqdm bar. What it raises comes out of here.
        :raises Cancelled: if it returned False, or cancel() was called.
        :raises KeyboardInterrupt: on Ctrl-C, soon; the workspace stays usable.
        :raises Error: BadCurve, BadUsage, ...: the sentence says what is wrong, and where.
        """
        return self._instance.run(point_fields, vertex_fields, as_progress(progress))

    def smooth(self, tau: Optional[OneOrEach] = None, *, point_fields: bool = False,
               vertex_fields: bool = False, progress: Any = None, **parameters: Any) -> Result:
        """set(tau=tau, **parameters) and run(); without ``tau`` it stays as it is."""
        if tau is not None:
            parameters["tau"] = tau
        self.set(**parameters)
        return self.run(point_fields=point_fields, vertex_fields=vertex_fields, progress=progress)

    def cancel(self) -> None:
        """From any thread: a run that is at work ends soon, with Cancelled."""
        self._instance.cancel()
