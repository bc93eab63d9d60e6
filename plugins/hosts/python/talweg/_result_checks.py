"""Checks of a plugin's results: a plugin by others may return nonsense."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple

import numpy as np

from . import _interface as c
from ._curves import Curve
from ._errors import Internal
from ._types import Array

_ROUNDING = 1e-6


class Limits(NamedTuple):
    """The bounds of indices in results: vertices and faces of the plugin's mesh, and the number of input
    curves."""

    vertices: int = 0
    faces: int = 0
    curves: int = 0


def guarded(plugin: str, take: Callable[[Any], None]) -> Callable[[Any], None]:
    """``take`` with its exceptions turned into Internal, which names the plugin."""

    def taken(given: Any) -> None:
        try:
            take(given)
        except MemoryError:
            raise
        except Exception as error:
            raise Internal(f"The plugin {plugin} gave an invalid result. {error}") from None

    return taken


def _check_rows(array: Array, rows: int, what: str) -> None:
    if len(array) != rows:
        raise ValueError(f"{what} has {len(array)} rows, not {rows}.")


def _check_indices(array: Array, count: int, what: str, least: int = 0) -> None:
    wrong = np.flatnonzero((array < least) | (array >= count))
    if wrong.size:
        row = int(wrong[0])
        raise ValueError(f"{what} has {array.reshape(-1)[row]} in row {row // _columns(array)}, but "
                         f"there are {count}.")


def _columns(array: Array) -> int:
    return array.shape[1] if array.ndim == 2 else 1


def _check_triples(array: Array, what: str) -> None:
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} does not have three columns.")
    wrong = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if wrong.size:
        raise ValueError(f"{what} has a number in row {wrong[0]} that is not finite.")


def check_curve(curve: Curve, limits: Limits) -> Curve:
    """Checks a curve of a result.

    :raises ValueError: if its arrays do not describe a curve on the mesh.
    """
    what = "A curve's list of "
    vertices, faces = curve.vertices, curve.faces
    weights, positions = curve.barycentrics, curve.positions
    assert vertices is not None and faces is not None and weights is not None
    assert positions is not None
    if len(faces) == 0:
        raise ValueError("A curve has no points.")
    for name, array in (("vertices", vertices), ("barycentrics", weights), ("positions", positions)):
        _check_rows(array, len(faces), what + name)
    _check_indices(vertices, limits.vertices, what + "vertices", -1)
    _check_indices(faces, limits.faces, what + "faces")
    _check_triples(weights, what + "barycentrics")
    if (weights < -_ROUNDING).any() or (np.abs(weights.sum(axis=1) - 1) > _ROUNDING).any():
        raise ValueError(what + "barycentrics has weights that are negative or do not add up to 1.")
    _check_triples(positions, what + "positions")
    for name, values in curve.fields.items():
        _check_rows(values, len(faces), f"A curve's field {name}")
    return curve


def check_field(name: str, values: Array, limits: Limits) -> Array:
    """Checks a field of a result.

    :raises ValueError: unless it has a value for each vertex, or for each face.
    """
    if len(values) != limits.faces:
        _check_rows(values, limits.vertices, f"The field {name}")
    return values


def check_mesh(vertices: Array, faces: Array) -> None:
    """Checks the lists of a made mesh.

    :raises ValueError: unless they are (n, 3) positions and (m, 3) indices of vertices.
    """
    _check_triples(vertices, "A mesh's list of positions")
    _check_triples(faces, "A mesh's list of triangles")
    _check_indices(faces, len(vertices), "A mesh's list of triangles")


def check_entry(entry: c.ReportEntry, curves: int) -> None:
    """Checks an entry of a report.

    :raises ValueError: if its key is null, its curve unknown, or its value unreadable.
    """
    if entry.key is None:
        raise ValueError("A key of the report is null.")
    what = f"The report's entry {entry.key.decode()}"
    if not -1 <= entry.curve < curves:
        raise ValueError(f"{what} is about curve {entry.curve}, but there are {curves}.")
    if not entry.is_list and entry.count != 1:
        raise ValueError(f"{what} has no single value.")
    values = entry.texts if entry.type == c.VALUE_TEXT else entry.numbers
    if entry.count and not values:
        raise ValueError(f"{what} has no values.")
    if entry.type == c.VALUE_TEXT and any(values[k] is None for k in range(entry.count)):
        raise ValueError("A text of the report is null.")


def check_origin(origin: Any, limits: Limits) -> None:
    """Checks the origin of a made mesh.

    :raises ValueError: if an index is out of the bounds of the original mesh, or a shape is wrong.
    """
    _check_rows(origin.weights, len(origin.vertices), "The weights of an origin")
    _check_triples(origin.weights, "The weights of an origin")
    _check_indices(origin.vertices, limits.vertices, "The vertices of an origin", -1)
    _check_indices(origin.faces, limits.faces, "The triangles of an origin", -1)
