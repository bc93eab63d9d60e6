"""The scene of a picture or a window: a surface, curves with names and colours, and a camera."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Mapping, Optional, Tuple

import numpy as np

from . import _arrays, _colors, _convert
from ._attributes import Parts
from ._camera import Camera, Stage
from ._curves import Curve, as_curves
from ._errors import BadCurve, BadMesh, BadUsage
from ._results import Result
from ._types import Array, Floats

DRAWN = "drawn"
MESH_UNITS = "mesh units"
RED, BLUE = "#c8281e", "#1450c0"
OTHERS = ("#1b7837", "#e08214", "#762a83", "#c51b7d", "#0d8a8a", "#6b4a1c")


@dataclass(frozen=True)
class Line:
    """Curves with one name, as polylines; a closed curve ends at its first point."""

    name: str
    color: str
    width: float  #: points
    polylines: List[Floats]
    marks: Floats  #: (k, 3), way-points


@dataclass(frozen=True)
class Scene:
    """Everything to be shown."""

    vertices: Floats
    faces: Array
    colors: Optional[_colors.Colors]
    lines: List[Line]
    camera: Camera


def scene(mesh: Any, curves: Any, view: Any, up: Any, zoom: float, colors: Any,
          size: Tuple[int, int]) -> Scene:
    """The scene for the arguments of show().

    :raises BadMesh, BadCurve, BadUsage: if an argument is wrong; the sentence names it.
    """
    parts = _parts(mesh)
    vertices = _arrays.readable(parts.vertices, 3, "The mesh's vertices", BadMesh)
    faces = _arrays.readable(parts.faces, 3, "The mesh's faces", BadMesh).astype(np.int64)
    vertices = vertices.astype(np.float64)
    if len(faces) == 0:
        raise BadMesh("The mesh has no faces to show.")
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise BadMesh(f"A face has the vertex {faces.min() if faces.min() < 0 else faces.max()}, and "
                      f"the mesh has {len(vertices)}.")
    lines = _lines(curves, vertices, faces)
    seen = faces[np.isfinite(vertices.sum(axis=1))[faces].all(axis=1)]
    if len(seen) == 0:
        raise BadMesh("No face of the mesh has finite coordinates.")
    stage = Stage(vertices, seen, [line for named in lines for line in named.polylines])
    view, up = _direction("view", view), _direction("up", up)
    width, height = _size(size)
    if not (isinstance(zoom, (int, float)) and 0 < zoom < np.inf):
        raise BadUsage(f"zoom must be a number greater than 0, not {zoom!r}.")
    return Scene(vertices, faces, _colors.of(colors, parts, len(vertices), len(faces)), lines,
                 stage.camera(view, up, zoom, width, height))


def _parts(mesh: Any) -> Parts:
    if isinstance(mesh, (list, tuple)) and len(mesh) == 2:
        return Parts(*mesh)
    return _convert.parts_of(mesh)


def _size(size: Tuple[int, int]) -> Tuple[int, int]:
    try:
        width, height = (int(value) for value in size)
    except (TypeError, ValueError):
        width = height = 0
    if not (16 <= width <= 8192 and 16 <= height <= 8192):
        raise BadUsage(f"size must be two whole numbers in [16, 8192], not {size!r}.")
    return width, height


def _direction(name: str, given: Any) -> Optional[Floats]:
    if given is None:
        return None
    try:
        vector = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):
        vector = np.zeros(0)
    if vector.shape != (3,) or not np.isfinite(vector).all() or not vector.any():
        raise BadUsage(f"{name} must be a direction, three numbers that are not all 0, not {given!r}.")
    return np.asarray(vector / np.abs(vector).max())


def _lines(curves: Any, vertices: Floats, faces: Array) -> List[Line]:
    named: Mapping[str, Any] = curves if isinstance(curves, Mapping) else {"": curves}
    result: List[Line] = []
    palette = iter((BLUE, *(OTHERS * (1 + len(named) // len(OTHERS)))))
    for name, given in named.items():
        if given is None or isinstance(given, Result) and not given.curves:
            continue
        drawn = name == DRAWN
        several = given.curves if isinstance(given, Result) else as_curves(given)
        result.append(Line(str(name), RED if drawn else next(palette), 1.4 if drawn else 2.2,
                           [polyline(curve, vertices, faces) for curve in several],
                           np.concatenate([_marks(curve, vertices, faces) for curve in several])))
    return result


def positions(curve: Curve, vertices: Floats, faces: Array) -> Floats:
    """The places of a curve's points, (n, 3), from the first present member, in the order of ``Curve``.

    :raises BadCurve: if the curve has no points, or indices that the mesh does not have.
    """
    numbers = None if curve.vertices is None else np.asarray(curve.vertices)
    if numbers is not None and (np.all(numbers != -1) or curve.faces is None is curve.positions):
        if len(numbers) == 0 or numbers.min() < 0 or numbers.max() >= len(vertices):
            raise BadCurve(f"The curve has no vertices, or some that the mesh of {len(vertices)} "
                           "vertices does not have.")
        return np.asarray(vertices[numbers])
    if curve.faces is not None and curve.barycentrics is not None:
        numbers, weights = np.asarray(curve.faces), np.asarray(curve.barycentrics, dtype=np.float64)
        if len(numbers) == 0 or numbers.min() < 0 or numbers.max() >= len(faces):
            raise BadCurve(f"The curve has no points, or faces that the mesh of {len(faces)} faces "
                           "does not have.")
        return np.asarray(np.einsum("nk,nkx->nx", weights, vertices[faces[numbers]]))
    points = np.asarray(np.zeros((0, 3)) if curve.positions is None else curve.positions, np.float64)
    if len(points) == 0 or not np.isfinite(points).all():
        raise BadCurve("The curve has no points, or some that are not finite.")
    return points


def polyline(curve: Curve, vertices: Floats, faces: Array) -> Floats:
    """positions(), with the first point repeated at the end of a closed curve."""
    points = positions(curve, vertices, faces)
    return np.vstack([points, points[:1]]) if curve.closed else points


def _marks(curve: Curve, vertices: Floats, faces: Array) -> Floats:
    """The way-points of a curve; empty if it has none, or if all points are way-points."""
    exact: Any = curve.exact
    if exact is None or np.ndim(exact) == 0:
        return np.zeros((0, 3))
    given = np.asarray(exact)
    at = given if given.dtype.kind == "b" else given >= 0
    return np.asarray(positions(curve, vertices, faces)[at])
