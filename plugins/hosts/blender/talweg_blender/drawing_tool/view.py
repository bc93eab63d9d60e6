"""Projection of points to the screen, and the search for the point or segment under the mouse."""

from functools import cached_property

import numpy as np


class View:
    """The projection of an object's space to a window.

    :param matrix: (4, 4), from the object's space to clip coordinates.
    :param width, height: of the window, pixels.
    """

    def __init__(self, matrix, width, height):
        self.matrix = np.array(matrix, float)
        self.half = np.array([width, height], float) / 2

    @cached_property
    def _inverse(self):
        return np.linalg.inv(self.matrix)

    def project(self, points):
        """(n, 2) pixels; NaN for points behind the eye."""
        points = np.asarray(points, float).reshape(-1, 3)
        clip = points @ self.matrix[:, :3].T + self.matrix[:, 3]
        with np.errstate(divide="ignore", invalid="ignore"):
            flat = clip[:, :2] / clip[:, 3:]
        flat[clip[:, 3] <= 0] = np.nan
        return (flat + 1) * self.half

    def ray(self, mouse):
        """Origin and unit direction of the ray through a pixel."""
        x, y = np.asarray(mouse, float) / self.half - 1
        near, far = (self._at(x, y, depth) for depth in (-1, 0.9))
        direction = far - near
        return near, direction / np.linalg.norm(direction)

    def _at(self, x, y, depth):
        found = self._inverse @ np.array([x, y, depth, 1])
        return found[:3] / found[3]

    def pixel_at(self, point):
        """The size of a pixel at the depth of the point, in the object's units."""
        here = self.project([point])[0]
        origin, direction = self.ray(here)
        beside, aside = self.ray(here + [1, 0])
        along = np.dot(np.subtract(point, origin), direction)
        return float(np.linalg.norm(beside + along * aside - origin - along * direction))


def nearest_point(projected, mouse, within):
    """Indices of the points at most ``within`` pixels from the mouse, the nearest first; eight at most."""
    off = np.linalg.norm(projected - mouse, axis=1)
    off[np.isnan(off)] = np.inf
    order = np.argsort(off, kind="stable")
    return [int(k) for k in order[:8] if off[k] <= within]


def nearest_segment(projected, closed, mouse, within):
    """The segment of a polyline at most ``within`` pixels from the mouse, and the place on it (0 to 1); None
    if there is none."""
    ends = np.vstack([projected, projected[:1]]) if closed else projected
    a, b = ends[:-1], ends[1:]
    if not len(a):
        return None
    side = b - a
    with np.errstate(divide="ignore", invalid="ignore"):
        t = ((mouse - a) * side).sum(axis=1) / (side * side).sum(axis=1)
    t = np.clip(np.nan_to_num(t), 0, 1)
    off = np.linalg.norm(a + t[:, None] * side - mouse, axis=1)
    off[np.isnan(off)] = np.inf
    k = int(off.argmin())
    return (k, float(t[k]), float(off[k])) if off[k] <= within else None
