"""What is drawn, as values: points on the mesh, lines of them, and the edits of a hand."""

from typing import NamedTuple, Tuple

import numpy as np

from ..package import talweg


class Point(NamedTuple):
    """On a triangle of the surface."""

    face: int
    barycentric: Tuple[float, float, float]
    position: Tuple[float, float, float]  # in the object's own space
    exact: bool = False  # clicked, or pinned: the result passes through it


class Line(NamedTuple):
    points: Tuple[Point, ...] = ()
    closed: bool = False
    finished: bool = False  # further clicks begin another one

    @property
    def is_curve(self):
        return len(self.points) >= (3 if self.closed else 2)

    @property
    def positions(self):
        """(n, 3)"""
        return np.array([point.position for point in self.points], float).reshape(-1, 3)

    def curve(self):
        """As Talweg takes it."""
        exact = np.array([point.exact for point in self.points])
        return talweg.Curve(faces=np.array([point.face for point in self.points]),
                            barycentrics=np.array([point.barycentric for point in self.points]),
                            closed=self.closed, exact=exact if exact.any() else None)


def distance(one, other):
    """Straight, between points."""
    return float(np.linalg.norm(np.subtract(one.position, other.position)))


def inserted(line, before, point):
    return line._replace(points=line.points[:before] + (point,) + line.points[before:])


def without(line, at):
    """The line without a point; None if too little is left."""
    left = line._replace(points=line.points[:at] + line.points[at + 1:])
    if left.closed and len(left.points) < 3:
        left = left._replace(closed=False)
    return left if left.points else None


def bent(line, at, to):
    """The line with its point moved, and without the stroke beside it: so far to either side as it
    moved. Points that are exact stay where they are."""
    reach = distance(line.points[at], to)
    kept = [to]
    for step in (-1, 1):
        run, last, k = 0.0, line.points[at], at + step
        side = []
        while 0 <= k < len(line.points):
            point = line.points[k]
            run += distance(last, point)
            is_end = not line.closed and k in (0, len(line.points) - 1)
            if run > reach or point.exact or is_end:
                side.append(point)
            last, k = point, k + step
        kept = [*side[::-1], *kept] if step < 0 else [*kept, *side]
    return line._replace(points=tuple(kept))


def place_on(line, along, segment):
    """Before which point of a line something belongs that lies on a segment of its result.

    :param along: (k, 3), the points of the result.
    """
    where = np.array([int(((along - p) ** 2).sum(axis=1).argmin()) for p in line.positions])
    if line.closed:
        where = (where - where[0]) % len(along)
        segment = (segment - int(((along - line.positions[0]) ** 2).sum(axis=1).argmin())) % len(along)
    where = np.maximum.accumulate(where)
    before = int(np.searchsorted(where, segment, side="right"))
    return before if line.closed else min(max(before, 1), len(line.points) - 1)
