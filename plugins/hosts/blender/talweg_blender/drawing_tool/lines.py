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
    """Before which point of a line something belongs that lies on a segment of its result; as leg_at() of
    talweg::editing, which is C++, says it.

    :param along: (k, 3), the points of the result.
    """
    given = line.positions
    if line.closed:  # from its point next to the first one, where it also ends
        first = int(((along - given[0]) ** 2).sum(axis=1).argmin())
        along = np.concatenate([along[first:], along[:first + 1]])
        segment = (segment - first) % (len(along) - 1)
    before = int(np.searchsorted(_passed_at(given, along), segment, side="right"))
    return max(before, 1) if line.closed else min(max(before, 1), len(given) - 1)


def _passed_at(given, along):
    """The point of a polyline next to each given one, in order, so that the sum of the squared distances
    is least: near stretches of a line that comes back are not taken for each other."""
    best = np.zeros(len(along))  # of the points so far, with the last one there or before
    reached = []  # where it is best to have the point there itself
    for point in given:
        here = best + ((along - point) ** 2).sum(axis=1)
        best = np.minimum.accumulate(here)
        reached.append(np.append(True, here[1:] < best[:-1]))
    at, last = [], len(along) - 1
    for there in reversed(reached):
        last = int(np.flatnonzero(there[:last + 1])[-1])
        at.append(last)
    return at[::-1]
