"""A depth buffer in numpy: the visible triangle at every pixel of a picture."""

from __future__ import annotations

from typing import Iterator, NamedTuple, Tuple

import numpy as np

from ._types import Array, Floats, Integers

NOTHING = -1
_ROWS, _SAMPLES = 1 << 19, 1 << 21  # at a time, which bounds the memory


class Buffer:
    """The nearest triangle at every pixel. Pixel (x, y) has its centre at (x, y); y points down; larger z is
    nearer."""

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self.faces: Integers = np.full(width * height, NOTHING, np.int64)
        self.depths: Floats = np.full(width * height, -np.inf)

    def draw(self, points: Floats, faces: Array) -> None:
        """Draws faces, in O(faces + covered rows of pixels + covered pixels). Faces with points that are not
        finite are left out.

        :param points: (n, 3), in pixels.
        """
        number = self._in_frame(points, faces)
        faces = faces[number]
        low, high = _pixels_of(points[:, 1], faces, self.height)
        low, rows = low.astype(np.int64), (high - low + 1).astype(np.int64)
        sides, depth = _sides_of(points, faces), _depth_of(points, faces)
        for part in _chunks(rows, _ROWS):
            face = np.repeat(np.arange(part.start, part.stop), rows[part])
            line = low[face] + _numbers_within(rows[part])
            left, right = sides.at(face, line)
            first = np.clip(np.ceil(left), 0, self.width).astype(np.int64)
            count = np.clip(np.floor(right), -1, self.width - 1).astype(np.int64) - first + 1
            some = np.flatnonzero(count > 0)
            face, line, first, count = face[some], line[some], first[some], count[some]
            z = depth.origin[face] + depth.by_x[face] * first + depth.by_y[face] * line
            pixel, by_x, face = line * self.width + first, depth.by_x[face], number[face]
            for run in _chunks(count, _SAMPLES):
                self._fill(pixel[run], count[run], z[run], by_x[run], face[run])

    def _in_frame(self, points: Floats, faces: Array) -> Integers:
        """Numbers of the faces that may cover a centre of a pixel."""
        low, high = _pixels_of(points[:, 1], faces, self.height)
        left, right = _pixels_of(points[:, 0], faces, self.width)
        number = np.flatnonzero((low <= high) & (left <= right))
        finite = np.isfinite(points.sum(axis=1))
        return np.asarray(number[finite[faces[number]].all(axis=1)])

    def _fill(self, first: Array, count: Array, z: Array, by_x: Array, face: Array) -> None:
        """Fills runs of pixels, each of which begins with the depth z."""
        run, step = np.repeat(np.arange(len(first)), count), _numbers_within(count)
        pixel, z, face = first[run] + step, z[run] + by_x[run] * step, face[run]
        while len(pixel) > 0:  # of several values for a pixel, the next round overwrites those behind
            nearer = np.flatnonzero(z > self.depths[pixel])
            pixel, z, face = pixel[nearer], z[nearer], face[nearer]
            self.depths[pixel] = z
            self.faces[pixel] = face


def _pixels_of(values: Floats, faces: Array, size: int) -> Tuple[Floats, Floats]:
    """The first and the last pixel between a face's values; the last is smaller than the first if there is
    none."""
    a, b, c = (values[faces[:, k]] for k in range(3))
    with np.errstate(invalid="ignore"):
        first = np.ceil(np.minimum(np.minimum(a, b), c))
        last = np.floor(np.maximum(np.maximum(a, b), c))
    return np.maximum(first, 0), np.minimum(last, size - 1)


class _Sides(NamedTuple):
    """The sides of triangles, from the highest corner to the lowest."""

    x0: Floats
    y0: Floats
    x1: Floats
    y1: Floats
    long: Floats  #: slope dx/dy of the side from corner 0 to corner 2
    upper: Floats
    lower: Floats

    def at(self, face: Array, line: Array) -> Tuple[Floats, Floats]:
        """The places where a row enters and leaves a triangle. Neighbours compute their common side equally,
        so there is no gap between them."""
        x0, y0, y1 = self.x0[face], self.y0[face], self.y1[face]
        one = x0 + (line - y0) * self.long[face]
        other = np.where(line < y1, x0 + (line - y0) * self.upper[face],
                         self.x1[face] + (line - y1) * self.lower[face])
        return np.minimum(one, other), np.maximum(one, other)


def _sides_of(points: Floats, faces: Array) -> _Sides:
    x, y = (points[:, k][faces] for k in range(2))
    order = np.argsort(y, axis=1, kind="stable")
    (x0, x1, x2), (y0, y1, y2) = (np.take_along_axis(v, order, axis=1).T.copy() for v in (x, y))

    def slope(x: Floats, y: Floats) -> Floats:
        return np.asarray(x / np.where(y > 0, y, np.inf))

    return _Sides(x0, y0, x1, y1, slope(x2 - x0, y2 - y0), slope(x1 - x0, y1 - y0),
                  slope(x2 - x1, y2 - y1))


class _Depth(NamedTuple):
    """z of triangles as a function of the pixel: origin + by_x x + by_y y."""

    origin: Floats
    by_x: Floats
    by_y: Floats


def _depth_of(points: Floats, faces: Array) -> _Depth:
    a = points[faces[:, 0]].T
    b, c = (points[faces[:, k]].T - a for k in (1, 2))
    area = b[0] * c[1] - b[1] * c[0]
    size = np.abs(b[0] * c[1]) + np.abs(b[1] * c[0])
    inverse = 1 / np.where(np.abs(area) > 1e-9 * size, area, np.inf)  # constant for triangles seen from the
                                                                      # side
    by_x = (b[2] * c[1] - c[2] * b[1]) * inverse
    by_y = (c[2] * b[0] - b[2] * c[0]) * inverse
    return _Depth(a[2] - by_x * a[0] - by_y * a[1], by_x, by_y)


def _numbers_within(counts: Array) -> Integers:
    """0, 1, ..., count - 1 for each of the counts, concatenated."""
    ends = np.cumsum(counts)
    total = int(ends[-1]) if len(ends) > 0 else 0
    return np.asarray(np.arange(total) - np.repeat(ends - counts, counts))


def _chunks(costs: Array, most: int) -> Iterator[slice]:
    """Consecutive slices whose costs sum to about ``most``."""
    ends = np.cumsum(costs)
    begin = 0
    while begin < len(costs):
        before = ends[begin - 1] if begin > 0 else 0
        end = max(begin + 1, int(np.searchsorted(ends, before + most, side="right")))
        yield slice(begin, end)
        begin = end
