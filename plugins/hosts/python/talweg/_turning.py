"""The turns of curves on a mesh: the library's signed_turning() and curvature_along() in numpy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

import numpy as np

from ._camera import normals_of, unit
from ._curves import Curve
from ._scene import positions
from ._types import Array, Floats, Integers


@dataclass(frozen=True)
class Turns:
    """The turns of a curve, in order along it."""

    at: Floats  #: (k,) mesh units along the curve, ascending, in [0, length]
    angle: Floats  #: (k,) radians, positive to the left
    length: float
    closed: bool

    def curvature_along(self, window: float) -> Tuple[Floats, Floats]:
        """Steps (k + 1,) along the curve, mesh units, and the curvature (k,) on each step, radians per mesh
        unit, positive to the left. The curvature at a place is the sum of the turns in the window around the
        place over the window's length.
        """
        at, angle = self.at, self.angle
        if self.closed:  # windows extend over the end, and are shorter than the curve
            window = min(window, (1 - 1e-12) * self.length)
            at = np.concatenate([at - self.length, at, at + self.length])
            angle = np.tile(angle, 3)
        steps = np.concatenate([at - window / 2, at + window / 2, [0, self.length]])
        steps = np.unique(np.clip(steps, 0, self.length))
        middle = 0.5 * (steps[:-1] + steps[1:])
        sums = np.r_[0, np.cumsum(angle)]
        inside = (sums[np.searchsorted(at, middle + window / 2)]
                  - sums[np.searchsorted(at, middle - window / 2)])
        return steps, np.asarray(inside / window)


def turns_of(curve: Curve, vertices: Floats, faces: Array) -> Turns:
    """The turns of a curve whose consecutive points share a face, in O(faces + points).

    A curve with only ``vertices`` runs along edges; otherwise ``faces`` has the face of each segment.
    """
    points = positions(curve, vertices, faces)
    n = len(points)
    ends = np.vstack([points, points[:1]]) if curve.closed else points
    lengths = np.linalg.norm(np.diff(ends, axis=0), axis=1)
    inner = np.arange(n) if curve.closed else np.arange(1, max(n - 1, 1))
    at = np.r_[0, np.cumsum(lengths)]
    angle = np.zeros(len(inner))
    number = _vertices_of(curve, n)
    of_face: Optional[Integers] = None if curve.faces is None else np.asarray(curve.faces, np.int64)
    crossing = number[inner] < 0
    if of_face is not None and crossing.any():
        angle[crossing] = _off_vertices(points, of_face, inner[crossing], vertices, faces)
    if not crossing.all():
        stars = _Stars(np.unique(number[inner[~crossing]]), vertices, faces)
        for k, i in zip(np.flatnonzero(~crossing), inner[~crossing].tolist()):
            before, after = (i - 1) % n, (i + 1) % n
            rays = [stars.ray(int(number[i]), int(number[other]), points[other],
                              None if of_face is None else int(of_face[segment]))
                    for other, segment in ((before, before), (after, i))]
            angle[k] = stars.turn(int(number[i]), *rays)
    return Turns(at[inner], angle, float(at[-1]), curve.closed)


def _vertices_of(curve: Curve, count: int) -> Integers:
    if curve.vertices is None:
        return np.full(count, -1, np.int64)
    return np.asarray(curve.vertices, dtype=np.int64)


def _off_vertices(points: Floats, of_face: Integers, inner: Integers, vertices: Floats,
                  faces: Array) -> Floats:
    """Turns at points inside faces and edges: the angle between the segments after their faces are unfolded
    into a plane about the common edge `e`."""
    n = len(points)
    before, after = of_face[(inner - 1) % n], of_face[inner]
    one, other = faces[before], faces[after]
    shared = (one[:, :, None] == other[:, None, :]).any(axis=2)
    # The common edge, against the orientation of the first face, so that the other face is on its left. Two
    # segments in one face may use any of its edges.
    first = np.where(before == after, 0, np.argmin(shared, axis=1) + 1) % 3
    rows = np.arange(len(one))
    e = unit(vertices[one[rows, first]] - vertices[one[rows, (first + 1) % 3]])

    def angle(corners: Array, direction: Floats) -> Floats:
        left = np.cross(unit(normals_of(vertices, corners)), e)
        return np.asarray(np.arctan2(np.sum(direction * left, axis=1),
                                     np.sum(direction * e, axis=1)))

    turned = (angle(other, points[(inner + 1) % n] - points[inner])
              - angle(one, points[inner] - points[(inner - 1) % n]))
    return np.asarray((turned + np.pi) % (2 * np.pi) - np.pi)


def _angle(u: Floats, v: Floats) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))


class _Stars:
    """The faces around some vertices. A direction at a vertex is an angle along the surface, counterclockwise
    from the vertex's first edge."""

    def __init__(self, centers: Integers, vertices: Floats, faces: Array) -> None:
        self._vertices = vertices
        near = np.zeros(len(vertices), bool)
        near[centers] = True
        corners: Dict[int, List[Tuple[int, int, int]]] = {int(v): [] for v in centers}
        for face in np.flatnonzero(near[faces].any(axis=1)).tolist():
            a, b, c = faces[face].tolist()
            for v, right, left in ((a, b, c), (b, c, a), (c, a, b)):
                if v in corners:
                    corners[v].append((face, right, left))
        self._edges: Dict[int, Dict[int, float]] = {}
        self._faces: Dict[int, Dict[int, Tuple[int, float]]] = {}
        self._around: Dict[int, Tuple[float, bool]] = {}
        for v, about in corners.items():
            self._lay_out(v, about)

    def _lay_out(self, v: int, about: List[Tuple[int, int, int]]) -> None:
        by_right = {right: (face, left) for face, right, left in about}
        lefts = {left for _, _, left in about}
        right = next((right for right in by_right if right not in lefts), min(by_right))
        edges, faces, angle = {right: 0.0}, {}, 0.0
        for _ in about:
            if right not in by_right:
                break
            face, left = by_right[right]
            faces[face] = (right, angle)
            angle += _angle(self._vertices[right] - self._vertices[v],
                            self._vertices[left] - self._vertices[v])
            if left in edges:
                break
            edges[left] = angle
            right = left
        self._edges[v], self._faces[v] = edges, faces
        self._around[v] = (angle, any(left not in by_right for left in lefts))

    def ray(self, v: int, vertex: int, point: Floats, face: Optional[int]) -> float:
        """The direction from v to a point, which is the vertex ``vertex`` or lies in ``face``."""
        if vertex in self._edges[v]:
            return self._edges[v][vertex]
        if face is None or face not in self._faces[v]:
            return 0.0
        right, angle = self._faces[v][face]
        return angle + _angle(self._vertices[right] - self._vertices[v], point - self._vertices[v])

    def turn(self, v: int, before: float, after: float) -> float:
        """Half the difference of the angles on the right and on the left; on the boundary, pi minus the angle
        inside."""
        around, at_boundary = self._around[v]
        if at_boundary:
            return np.pi - (before - after) if before > after else (after - before) - np.pi
        left = (before - after) % around if around > 0 else 0.0
        return 0.5 * around - left
