"""Smooth curves on triangle meshes while they stay close to what was drawn.

>>> import talweg
>>> drawn = talweg.draw(vertices, faces, [12, 845, 9001])   # vertices -> way-points
>>> result = talweg.smooth(vertices, faces, drawn, tau=2)
>>> result.curve.positions, result.report.farthest

``Mesh`` opens a mesh once for many curves; ``Workspace`` keeps a curve while tau moves.
``talweg.help_text()`` tells all parameters. Lengths are in mesh units, angles in radians.
"""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from ._curves import Curve, CurveLike
from ._errors import (BadCurve, BadFile, BadMesh, BadUsage, Cancelled, Error, Internal, Numerical,
                      OutOfMemory, PluginNotFound, Unsupported)
from ._files import read_curves, write_curves
from ._made import Chain, MadeMesh, Origin
from ._mesh import Mesh, read_mesh, write_mesh
from ._pipeline import Cut, Labels, Measurement, Repair, cut, inspect, labels, measure, offset, repair
from ._plot import plot_curvature
from ._plugins import Parameter, Plugin, folders, help_text, plugin, plugins
from ._results import Distance, Report, Result
from ._show import show
from ._types import ArrayLike
from ._version import __version__
from ._workspace import OneOrEach, Workspace

__all__ = [
    "BadCurve", "BadFile", "BadMesh", "BadUsage", "Cancelled", "Chain", "Curve", "Cut", "Distance",
    "Error", "Internal", "Labels", "MadeMesh", "Measurement", "Mesh", "Numerical", "Origin",
    "OutOfMemory", "Parameter", "Plugin", "PluginNotFound", "Repair", "Report", "Result",
    "Unsupported", "Workspace", "__version__", "cut", "distance", "draw", "folders", "geodesic",
    "help_text", "inspect", "labels", "measure", "offset", "plot_curvature", "plugin", "plugins",
    "read_curves", "read_mesh", "repair", "show", "smooth", "write_curves", "write_mesh"
]


def smooth(vertices: Any, faces: ArrayLike, curve: Union[CurveLike, Sequence[Curve]],
           tau: OneOrEach = 1.0, *, closed: bool = False, point_fields: bool = False,
           vertex_fields: bool = False, progress: Any = None, **parameters: Any) -> Result:
    """Smooths a drawn curve while it stays close to the drawing.

    :param vertices: (n, 3) real numbers, mesh units.
    :param faces: (m, 3) whole numbers, counterclockwise from outside.
    :param curve: vertices (k,), neighbours along edges; or positions (k, 3) near the surface; or
        a ``Curve``; or a list of ``Curve``: smoothed together, none crosses another.
    :param tau: >= 0. 0: straight lines; more keeps closer to the drawing. A list has one for each
        curve, as those of ``slack`` and ``finish`` do; None there: as for all.
    :param closed: the curve is a loop (also if its vertices repeat the first one at the end).
    :param point_fields: also ``curve.fields``: "deviation" (mesh units), "curvature" (radians).
    :param vertex_fields: also ``result.fields``: "distance" to the drawing, (n,), mesh units.
    :param progress: a function (stage, fraction in [0, 1]) that may return False to cancel, or a
        tqdm bar.
    :param parameters: any of ``talweg.help_text()``: ``slack``, ``max_deviation``, ``pin``,
        ``points`` ("given", "exact", "rough"), ``exact`` (vertices that are way-points), ...
    :raises BadMesh, BadCurve, BadUsage: with a sentence that says what is wrong, and where.
    :raises Cancelled, KeyboardInterrupt: there is no result then.

    The method: Pawellek, Roessl, Lawonn, Distance-Based Smoothing of Curves on Surface Meshes.
    """
    return Mesh(vertices, faces).smooth(curve, tau, closed=closed, point_fields=point_fields,
                                        vertex_fields=vertex_fields, progress=progress,
                                        **parameters)


def draw(vertices: Any, faces: ArrayLike, points: CurveLike, *, closed: bool = False,
         straight: Optional[bool] = None, exact: bool = True, **parameters: Any) -> Curve:
    """A curve through points in their order: straight over the surface, or along edges of the mesh.

    The points are its way-points (``Curve.exact``): smooth() is free between them.

    :param points: vertices (k,), k >= 2, anywhere; where it is straight also positions or a Curve.
    :param closed: back to the first point (also if the vertices repeat it at the end).
    :param straight: straight over the faces, where it may cross itself, or along edges between
        vertices, where it never does. None: straight if the points are way-points.
    :param exact: False: the curve is a stroke, and smooth() keeps near it.
    :param parameters: ``ridges`` [0, 1], ``ridge_kind`` ("both", "convex", "concave") and ``ridge_band``
        (mesh units, > 0): how strongly ridges attract the curve and its points, which, from how far.
    :raises BadCurve: if there is no way, or it would cross itself.
    """
    return Mesh(vertices, faces, plugin="talweg.draw").draw(points, closed=closed,
                                                            straight=straight, exact=exact,
                                                            **parameters)


def geodesic(vertices: Any, faces: ArrayLike, curve: Union[CurveLike, Sequence[Curve]], *,
             closed: bool = False, point_fields: bool = False, progress: Any = None,
             **parameters: Any) -> Result:
    """Straightens a curve until it is locally shortest: a geodesic path, or a closed geodesic.

    :param curve: as for smooth(), but points need not be neighbours. Its pins stay; with
        ``through=True`` all of its points.
    """
    return Mesh(vertices, faces, plugin="talweg.geodesic").geodesic(
        curve, closed=closed, point_fields=point_fields, progress=progress, **parameters)


def distance(vertices: Any, faces: ArrayLike, curve: Union[CurveLike, Sequence[Curve]], *,
             closed: bool = False, progress: Any = None, **parameters: Any) -> Distance:
    """Distance along the surface to the nearest curve, and the potential that smooth() makes of it.

    :param curve: as for smooth().
    :param parameters: ``potential`` "corridor" (exact distance) or "paper" (heat method), ``tau``,
        ``slack``, ``heat_time``, ``threads``.
    """
    return Mesh(vertices, faces, plugin="talweg.distance").distance(
        curve, closed=closed, progress=progress, **parameters)


for _name in __all__:  # people see talweg.BadCurve, not where it is written
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
del _name
