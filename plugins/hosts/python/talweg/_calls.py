"""One call each to draw, to smooth, for geodesics and for distances."""

from __future__ import annotations

import functools
import warnings
from typing import Any, Callable, Dict, Optional, Sequence, Tuple, TypeVar, Union, cast

from ._curves import Curve, CurveLike
from ._pipeline import mesh_of
from ._results import Distance, Result
from ._workspace import OneOrEach

_Call = TypeVar("_Call", bound=Callable[..., Any])


def mesh_first(function: _Call) -> _Call:
    """A decorator: the function also accepts the arguments before version 0.2, (vertices, faces, ...), with a
    warning."""

    @functools.wraps(function)
    def call(*given: Any, **named: Any) -> Any:
        if not _begins_with_arrays(given, named):
            return function(*given, **named)
        warnings.warn(f"talweg.{function.__name__}(vertices, faces, ...) is deprecated and will be removed in "
                      f"the next release; call talweg.{function.__name__}((vertices, faces), ...).",
                      DeprecationWarning, stacklevel=2)
        vertices = given[0] if given else named.pop("vertices")
        faces = given[1] if len(given) > 1 else named.pop("faces", None)
        return function(vertices if faces is None else (vertices, faces), *given[2:], **named)

    return cast(_Call, call)


def _begins_with_arrays(given: Tuple[Any, ...], named: Dict[str, Any]) -> bool:
    if "vertices" in named or "faces" in named or (len(given) > 1 and given[1] is None):
        return True
    if len(given) + ("curve" in named or "points" in named) < 3:
        return False
    if isinstance(given[0], (list, tuple)):
        return len(given[0]) != 2  # a pair (vertices, faces) is a mesh
    return hasattr(given[0], "__array__")


@mesh_first
def smooth(mesh: Any, curve: Union[CurveLike, Sequence[Curve]], tau: OneOrEach = 1.0, *,
           closed: bool = False, point_fields: bool = False, vertex_fields: bool = False,
           progress: Any = None, **parameters: Any) -> Result:
    """Smooths a drawn curve and keeps it close to the drawing.

    :param mesh: a ``Mesh``; a pair (vertices, faces), (n, 3) real numbers in mesh units and (m, 3) whole
        numbers, counterclockwise from outside; a file; or a mesh of another package.
    :param curve: vertices (k,), neighbours along edges; or positions (k, 3) near the surface; or a ``Curve``;
        or a list of ``Curve``, which are smoothed together so that none crosses another.
    :param tau: >= 0. 0: straight lines; a larger value keeps the curve closer to the drawing. A list has a
        value for each curve; None there: the value for all curves. ``slack`` and ``finish`` may be lists,
        too.
    :param closed: the curve is a loop (also if its vertices repeat the first one at the end).
    :param point_fields: also ``curve.fields``: "deviation" (mesh units), "curvature" (radians).
    :param vertex_fields: also ``result.fields``: "distance" to the drawing, (n,), mesh units.
    :param progress: a function (stage, fraction in [0, 1]) that may return False to cancel, or a
        tqdm bar.
    :param parameters: any of ``talweg.help_text()``: ``slack``, ``max_deviation``, ``pin``,
        ``points`` ("given", "exact", "rough"), ``exact`` (vertices that are way-points), ...
    :raises BadMesh, BadCurve, BadUsage: if the input is wrong; the sentence says what is wrong, and where.
    :raises Cancelled, KeyboardInterrupt: if the run was cancelled; there is no result.

    The method: Pawellek, Roessl, Lawonn, Distance-Based Smoothing of Curves on Surface Meshes.
    """
    return mesh_of(mesh, "talweg.smooth").smooth(
        curve, tau, closed=closed, point_fields=point_fields, vertex_fields=vertex_fields,
        progress=progress, **parameters)


@mesh_first
def draw(mesh: Any, points: CurveLike, *, closed: bool = False, straight: Optional[bool] = None,
         exact: bool = True, **parameters: Any) -> Curve:
    """A curve through points in their order: straight over the surface, or along edges of the mesh.

    The points are its way-points (``Curve.exact``): smooth() keeps them, and is free between them.

    :param mesh: as for smooth().
    :param points: vertices (k,), k >= 2, which need not be neighbours; for a straight curve also positions
        (k, 3) or a Curve.
    :param closed: the curve returns to the first point (also if the vertices repeat the first one at the
        end).
    :param straight: True: straight over the faces; the curve may cross itself. False: along edges between
        vertices; the curve never crosses itself. None: straight if the points are way-points.
    :param exact: False: the curve is a stroke, and smooth() stays near it.
    :param parameters: ``ridges`` [0, 1], ``ridge_kind`` ("both", "convex", "concave") and ``ridge_band``
        (mesh units, > 0): the strength with which ridges attract the curve and its points, the kind of
        ridges, and their reach.
    :returns: the ``Curve``.
    :raises BadCurve: if no path joins the points, or a path along edges would cross itself.
    :raises BadMesh, BadUsage: if the mesh or a parameter is wrong.
    """
    return mesh_of(mesh, "talweg.draw").draw(points, closed=closed,
                                                            straight=straight, exact=exact,
                                                            **parameters)


@mesh_first
def geodesic(mesh: Any, curve: Union[CurveLike, Sequence[Curve]], *,
             closed: bool = False, point_fields: bool = False, progress: Any = None,
             **parameters: Any) -> Result:
    """Straightens a curve until it is locally shortest: a geodesic path, or a closed geodesic.

    :param mesh: as for smooth().
    :param curve: as for smooth(), but vertices need not be neighbours. Its pins stay; with ``through=True``
        all of its points stay.
    :raises BadMesh, BadCurve, BadUsage, Cancelled: as smooth().
    """
    return mesh_of(mesh, "talweg.geodesic").geodesic(
        curve, closed=closed, point_fields=point_fields, progress=progress, **parameters)


@mesh_first
def distance(mesh: Any, curve: Union[CurveLike, Sequence[Curve]], *,
             closed: bool = False, progress: Any = None, **parameters: Any) -> Distance:
    """Distance along the surface to the nearest curve, and the potential that smooth() computes from it, at
    each vertex.

    :param mesh: as for smooth().
    :param curve: as for smooth().
    :param parameters: ``potential`` "corridor" (exact distance) or "paper" (heat method), ``tau``, ``slack``,
        ``heat_time``, ``threads``.
    :raises BadMesh, BadCurve, BadUsage, Cancelled: as smooth().
    """
    return mesh_of(mesh, "talweg.distance").distance(
        curve, closed=closed, progress=progress, **parameters)
