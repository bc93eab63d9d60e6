"""A drawing as immutable values: points on the mesh, lines of points, and edits of lines."""

from typing import NamedTuple, Tuple

import numpy as np

from ..package import talweg


class Point(NamedTuple):
    """A point in a triangle of the surface."""

    face: int
    barycentric: Tuple[float, float, float]
    position: Tuple[float, float, float]  # in the space of the object
    exact: bool = False  # a way-point or a pin: the result passes through it


class Line(NamedTuple):
    points: Tuple[Point, ...] = ()
    closed: bool = False
    finished: bool = False  # the next point begins another line

    @property
    def is_curve(self):
        return len(self.points) >= (3 if self.closed else 2)

    @property
    def positions(self):
        """(n, 3)"""
        return np.array([point.position for point in self.points], float).reshape(-1, 3)

    def curve(self):
        """The talweg.Curve of the line."""
        exact = np.array([point.exact for point in self.points])
        return talweg.Curve(faces=np.array([point.face for point in self.points]),
                            barycentrics=np.array([point.barycentric for point in self.points]),
                            closed=self.closed, exact=exact if exact.any() else None)


def distance(one, other):
    """The straight distance between two points."""
    return float(np.linalg.norm(np.subtract(one.position, other.position)))


def inserted(line, before, point):
    return line._replace(points=line.points[:before] + (point,) + line.points[before:])


def without(line, at):
    """The line without one of its points; None if no point is left."""
    left = line._replace(points=line.points[:at] + line.points[at + 1:])
    if left.closed and len(left.points) < 3:
        left = left._replace(closed=False)
    return left if left.points else None


def bent(line, at, to):
    """The line with one point moved to ``to``. Points of the stroke on either side, up to the length of the
    move, are removed; exact points stay."""
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
    """The index at which a new point is inserted into the drawn line. The new point was picked on ``segment``
    of the result. The same as leg_at() of talweg::editing in C++.

    :param along: (k, 3), the points of the result.
    """
    given = line.positions
    if line.closed:  # turned, so that it begins and ends at its point nearest to the first drawn point
        first = int(((along - given[0]) ** 2).sum(axis=1).argmin())
        along = np.concatenate([along[first:], along[:first + 1]])
        segment = (segment - first) % (len(along) - 1)
    before = int(np.searchsorted(_passed_at(given, along), segment, side="right"))
    return max(before, 1) if line.closed else min(max(before, 1), len(given) - 1)


def _passed_at(given, along):
    """For each given point a point of a polyline, in ascending order, with the least sum of squared
    distances. The order keeps apart stretches of a line that comes back close to itself."""
    best = np.zeros(len(along))  # best[i]: least sum for the points so far, with the last at i or before
    reached = []  # reached[p][i]: the sum is least with point p at i itself
    for point in given:
        here = best + ((along - point) ** 2).sum(axis=1)
        best = np.minimum.accumulate(here)
        reached.append(np.append(True, here[1:] < best[:-1]))
    at, last = [], len(along) - 1
    for there in reversed(reached):
        last = int(np.flatnonzero(there[:last + 1])[-1])
        at.append(last)
    return at[::-1]
