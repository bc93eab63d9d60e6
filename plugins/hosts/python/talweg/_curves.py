"""Curves on meshes, as input and as results."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _arrays
from . import _interface as c
from ._errors import BadCurve
from ._types import Array, ArrayLike, Floats


@dataclass(frozen=True, eq=False, repr=False)
class Curve:
    """A curve on a mesh.

    As input, the points are given by the first present of: ``vertices``; ``faces`` with ``barycentrics``;
    ``positions``, which are moved to the nearest points of the mesh. Consecutive points without a common
    triangle are joined straight over the surface. Consecutive ``vertices`` must be neighbours
    (``talweg.draw`` joins others).

    A result has all of these members. Each point and the next lie in one triangle, which ``faces`` names.
    """

    vertices: Optional[ArrayLike] = None  #: (n,) vertex numbers; in results -1 at points that are not a vertex
    faces: Optional[ArrayLike] = None  #: (n,) triangle numbers
    barycentrics: Optional[ArrayLike] = None  #: (n, 3), >= 0, rows sum to 1
    positions: Optional[ArrayLike] = None  #: (n, 3), mesh units
    closed: bool = False  #: whether the last point is joined to the first, which is not repeated
    pins: Sequence[int] = ()  #: indices of points that must not move
    #: In results, if requested: (n,) each; "deviation" in mesh units, "curvature" in radians
    fields: Dict[str, Array] = field(default_factory=dict)
    #: Which points are way-points, which the result must pass. None: none; the curve is a stroke. True: all.
    #: A number: all, within this tolerance in mesh units. (n,) booleans, or (n,) tolerances, with -1 at
    #: points that are not marked and -2 at painted ones. Results and files have (n,) numbers, with -3 at
    #: control points of another program.
    exact: Union[None, bool, float, ArrayLike] = None

    def __len__(self) -> int:
        for points in (self.vertices, self.faces, self.positions):
            if points is not None:
                return len(points)
        return 0

    def __repr__(self) -> str:
        return f"<talweg.Curve: {'closed' if self.closed else 'open'}, {len(self)} points>"

    @property
    def length(self) -> float:
        """Length of the polyline through ``positions``, mesh units."""
        if self.positions is None:
            raise BadCurve("The curve has no positions, so its length is not known.")
        points = np.asarray(self.positions, dtype=np.float64)
        if self.closed:
            points = np.vstack([points, points[:1]])
        return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


CurveLike = Union[Curve, ArrayLike]


def as_curve(given: CurveLike, closed: bool = False) -> Curve:
    """A Curve unchanged; (n,) whole numbers as vertices; (n, 3) real numbers as positions.

    Vertices whose last repeats the first are a closed curve.

    :raises BadCurve: for anything else.
    """
    if isinstance(given, Curve):
        return given
    try:
        array = np.asarray(given)
    except ValueError:
        array = np.asarray(None)
    if array.ndim == 1 and array.dtype.kind in "iu":
        if len(array) > 1 and array[0] == array[-1]:
            return Curve(vertices=array[:-1], closed=True)
        return Curve(vertices=array, closed=closed)
    if array.ndim == 2 and array.shape[1] == 3 and array.dtype.kind == "f":
        return Curve(positions=array, closed=closed)
    if array.size == 0:
        raise BadCurve("A curve has no points.")
    raise BadCurve("A curve must be a talweg.Curve, vertices (n,) of whole numbers, or positions "
                   "(n, 3) of real numbers"
                   + (f", not {array.dtype} {array.shape}." if array.ndim else ".")
                   + " A set of curves is a list of talweg.Curve.")


def as_curves(given: Union[CurveLike, Sequence[Curve]], closed: bool = False) -> List[Curve]:
    """A list or tuple of Curve as several curves; anything else as one curve."""
    if isinstance(given, (list, tuple)) and any(isinstance(one, Curve) for one in given):
        return [as_curve(one) for one in given]
    return [as_curve(given, closed)]


def marks(curve: Curve) -> Optional[Floats]:
    """``exact`` as one number for each point, (n,); None if it is None or False.

    :raises BadCurve: if ``exact`` has another type or shape.
    """
    if curve.exact is None or curve.exact is False:
        return None
    given = np.asarray(curve.exact)
    if given.ndim == 0 and given.dtype.kind in "biuf":
        tolerance = 0.0 if given.dtype.kind == "b" else float(given)
        return np.full(len(curve), tolerance)
    if given.shape != (len(curve),) or given.dtype.kind not in "biuf":
        raise BadCurve(f"The curve's exact must be True, a tolerance, or ({len(curve)},) of these, "
                       f"not {given.dtype} {given.shape}.")
    if given.dtype.kind == "b":
        return np.where(given, 0.0, c.MARK_NONE)
    return given.astype(np.float64)


def _keep_marks(curve: c.Curve, given: Curve, kept: List[Any]) -> None:
    values = marks(given)
    if values is None:
        return
    exact = c.Field(ctypes.sizeof(c.Field), c.EXACT, b"mesh units", _arrays.view(values))
    fields = (ctypes.POINTER(c.Field) * 1)(ctypes.pointer(exact))
    kept.extend([values, exact, fields])
    curve.field_count, curve.fields = 1, fields


def _copied_fields(curve: c.Curve) -> Dict[str, Array]:
    fields = {}
    for k in range(curve.field_count):
        one = curve.fields[k].contents
        fields[one.name.decode()] = _arrays.copied(one.values)
    return fields


def _keep(curve: c.Curve, name: str, values: Any, columns: int, kept: List[Any]) -> None:
    array = _arrays.readable(values, columns, f"The curve's {name}", BadCurve)
    kept.append(array)
    setattr(curve, name, _arrays.view(array))


def views(curves: Sequence[Curve]) -> Tuple[Any, List[Any]]:
    """The argument of set_curves, and the arrays that must be kept while it is used."""
    kept: List[Any] = []
    pointers = (ctypes.POINTER(c.Curve) * len(curves))()
    for k, given in enumerate(curves):
        curve = c.Curve(size=ctypes.sizeof(c.Curve), closed=int(given.closed))
        if given.vertices is not None and np.all(np.asarray(given.vertices) != -1):
            _keep(curve, "vertices", given.vertices, 1, kept)
        elif given.faces is not None or given.barycentrics is not None:
            for name, columns in (("faces", 1), ("barycentrics", 3)):
                values = getattr(given, name)
                if values is None:
                    raise BadCurve("A curve needs both faces and barycentrics, or neither.")
                _keep(curve, name, values, columns, kept)
        elif given.vertices is not None:
            _keep(curve, "vertices", given.vertices, 1, kept)  # set_curves refuses a -1, with a sentence
        elif given.positions is not None:
            _keep(curve, "positions", given.positions, 3, kept)
        if len(given.pins) > 0:
            _keep(curve, "pins", given.pins, 1, kept)
        _keep_marks(curve, given, kept)
        kept.append(curve)
        pointers[k] = ctypes.pointer(curve)
    return pointers, kept


def whole_views(curves: Sequence[Curve]) -> Tuple[Any, List[Any]]:
    """Views of results with all their members, for writing, and the arrays that must be kept."""
    kept: List[Any] = []
    pointers = (ctypes.POINTER(c.Curve) * len(curves))()
    for k, given in enumerate(curves):
        curve = c.Curve(size=ctypes.sizeof(c.Curve), closed=int(given.closed))
        if given.vertices is not None:
            indices = _arrays.readable(given.vertices, 1, "The curve's vertices", BadCurve)
            none = np.where(indices == -1, c.NO_VERTEX, indices)
            _keep(curve, "vertices", none.astype(np.uint32), 1, kept)
        for name, columns in (("faces", 1), ("barycentrics", 3), ("positions", 3)):
            if getattr(given, name) is not None:
                _keep(curve, name, getattr(given, name), columns, kept)
        _keep_marks(curve, given, kept)
        kept.append(curve)
        pointers[k] = ctypes.pointer(curve)
    return pointers, kept


def copied_input(curve: c.Curve) -> Curve:
    """A plugin's input curve: vertices, or faces and barycentrics, or positions."""
    return Curve(
        _arrays.copied_indices(curve.vertices) if curve.vertices.rows else None,
        _arrays.copied_indices(curve.faces) if curve.faces.rows else None,
        _arrays.copied(curve.barycentrics) if curve.barycentrics.rows else None,
        _arrays.copied(curve.positions) if curve.positions.rows else None, bool(curve.closed),
        tuple(_arrays.copied_indices(curve.pins).tolist()) if curve.pins.rows else (),
        exact=_copied_fields(curve).get(c.EXACT.decode()))


def copied(curve: c.Curve) -> Curve:
    """A plugin's result curve."""
    fields = _copied_fields(curve)
    exact = fields.pop(c.EXACT.decode(), None)
    return Curve(_arrays.copied_indices(curve.vertices), _arrays.copied_indices(curve.faces),
                 _arrays.copied(curve.barycentrics), _arrays.copied(curve.positions),
                 bool(curve.closed), (), fields, exact)
