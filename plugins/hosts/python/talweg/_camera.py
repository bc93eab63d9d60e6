"""The camera of a picture, an orthographic projection as in talweg-picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Sequence

import numpy as np

from . import _raster
from ._types import Array, Floats

_THUMBNAIL, _DIRECTIONS, _SAMPLES = 96, 48, 500
_CELLS = 40  # cells of the coarse mesh for thumbnails along its longest side
_MARGIN, _AROUND = 0.05, 1.2


@dataclass(frozen=True)
class Camera:
    """The rows of ``axes`` point to the right, up, and towards the viewer."""

    axes: Floats
    center: Floats
    scale: float  #: pixels per mesh unit
    width: int
    height: int

    def project(self, points: Array) -> Floats:
        """(n, 3) in pixels, the input of _raster.Buffer."""
        seen: Floats = (np.asarray(points, dtype=np.float64) - self.center) @ (
            self.scale * self.axes * np.array([[1], [-1], [1]])).T
        seen[:, :2] += ((self.width - 1) / 2, (self.height - 1) / 2)
        return seen

    def times(self, factor: int) -> Camera:
        """The same view with ``factor`` times as many pixels in each direction."""
        return Camera(self.axes, self.center, self.scale * factor, self.width * factor,
                      self.height * factor)


def axes_for(direction: Array, up: Array) -> Floats:
    """The axes of a camera whose viewer is in this direction from the mesh."""
    forward = direction / np.linalg.norm(direction)
    right = np.cross(up / np.linalg.norm(up), forward)
    if np.linalg.norm(right) < 1e-6:  # the view is along `up`: an axis serves as the upright direction
        right = np.cross(np.eye(3)[np.argmin(np.abs(forward))], forward)
    right = right / np.linalg.norm(right)
    return np.stack([right, np.cross(forward, right), forward])


def framed(axes: Floats, low: Array, high: Array, width: int, height: int) -> Camera:
    """A camera that shows the box from ``low`` to ``high``, which are coordinates along the axes."""
    size = np.maximum(high - low, np.finfo(float).tiny)
    free = 1 - 2 * _MARGIN
    return Camera(axes, axes.T @ (0.5 * (low + high)),
                  float(min(free * width / size[0], free * height / size[1])), width, height)


class Stage:
    """A mesh and the points of curves on it, and the view that shows them best.

    :param vertices: (n, 3), finite where faces use them.
    :param curves: (k, 3) each.
    """

    def __init__(self, vertices: Floats, faces: Array, curves: Sequence[Floats]) -> None:
        self.vertices, self.faces = vertices, faces
        self.points = _coarse_samples(curves)
        used = np.zeros(len(vertices), bool)
        used[faces.reshape(-1)] = True
        self._shown = np.flatnonzero(used)
        self._coarse = _coarse_mesh(vertices, faces, self._shown)
        self._normals = normals_of(*self._coarse)  # normals with twice the area as length
        self._facing = unit(self._normals)

    def upright(self) -> Floats:
        """The upright direction: y; for open sheets such as terrains, the side that the sheet faces."""
        normal = self._normals.sum(axis=0)
        if np.linalg.norm(normal) > 0.5 * np.linalg.norm(self._normals, axis=1).sum() > 0:
            along = self._coarse[0] @ axes_for(normal, np.array([0.0, 1, 0])).T
            size = along.max(axis=0) - along.min(axis=0)
            if size[2] < 0.4 * min(size[0], size[1]):
                return np.asarray(normal / np.linalg.norm(normal))
        return np.array([0.0, 1, 0])

    def direction(self, up: Floats) -> Floats:
        """The direction to the viewer that shows most of the curves; without curves, most of the mesh."""
        best, most = np.array([0.0, 0, 1]), -1.0
        for direction in _directions(up):
            height = float(direction @ up) / float(np.linalg.norm(up))
            value = self._seen(direction, up) * (1 - 0.25 * abs(height - 0.45))
            if value > most:
                best, most = direction, value
        return best

    def _seen(self, direction: Floats, up: Floats) -> float:
        vertices, faces = self._coarse
        axes = axes_for(direction, up)
        along = vertices @ axes.T
        camera = framed(axes, along.min(axis=0), along.max(axis=0), _THUMBNAIL, _THUMBNAIL)
        buffer = _raster.Buffer(_THUMBNAIL, _THUMBNAIL)
        buffer.draw(camera.project(vertices), faces)
        if len(self.points) == 0:
            return float(np.count_nonzero(buffer.faces != _raster.NOTHING)) / camera.scale**2
        at = camera.project(self.points)
        pixel = np.clip(np.rint(at[:, :2]).astype(np.int64), 0, _THUMBNAIL - 1)
        pixels = pixel[:, 1] * _THUMBNAIL + pixel[:, 0]
        face = buffer.faces[pixels]
        clear = (face != _raster.NOTHING) & (buffer.depths[pixels] <= at[:, 2] + 4)
        # A face counts fully up to an angle of about 55 degrees.
        return float((clear * np.clip(self._facing[face] @ direction / 0.57, 0, 1)).sum())

    def camera(self, view: Optional[Array], up: Optional[Array], zoom: float, width: int,
               height: int) -> Camera:
        """A camera that shows the curves with their surroundings, or the whole mesh where little would be cut
        off."""
        upright = self.upright() if up is None else np.asarray(up, dtype=np.float64)
        direction = self.direction(upright) if view is None else np.asarray(view, dtype=np.float64)
        axes = axes_for(direction, upright)
        along = self.vertices[self._shown] @ axes.T
        low, high = along.min(axis=0), along.max(axis=0)
        if len(self.points) > 0:
            points = self.points @ axes.T
            grow = _AROUND * (points.max(axis=0) - points.min(axis=0))[:2].max()
            near = np.maximum(low, points.min(axis=0) - grow)
            far = np.minimum(high, points.max(axis=0) + grow)
            with np.errstate(divide="ignore", invalid="ignore"):
                seen = np.nanmin((far - near)[:2] / (high - low)[:2])
            if not seen > 0.75:
                low, high = near, far
        camera = framed(axes, low, high, width, height)
        return Camera(axes, camera.center, camera.scale * zoom, width, height)


def _directions(up: Floats) -> Floats:
    """Directions spread evenly over the sphere, with "up" as the pole."""
    k = np.arange(_DIRECTIONS)
    z = 1 - 2 * (k + 0.5) / _DIRECTIONS
    r, angle = np.sqrt(1 - z * z), np.pi * (3 - np.sqrt(5)) * k
    around = np.stack([r * np.cos(angle), r * np.sin(angle), z], axis=1)
    return np.asarray(around @ axes_for(up, np.array([1, 0.3, 0])))


def _coarse_samples(curves: Sequence[Floats]) -> Floats:
    """Points in equal steps along the curves."""
    lengths = [np.linalg.norm(np.diff(points, axis=0), axis=1) for points in curves]
    whole = sum(float(each.sum()) for each in lengths)
    result = [np.zeros((0, 3))]
    for points, each in zip(curves, lengths):
        at = np.r_[0, np.cumsum(each)]
        count = 2 + int(_SAMPLES * at[-1] / whole) if whole > 0 else 1
        steps = np.linspace(0, at[-1], count)
        result.append(np.stack([np.interp(steps, at, points[:, k]) for k in range(3)], axis=1))
    return np.concatenate(result)


def normals_of(vertices: Floats, faces: Array) -> Floats:
    """(m, 3), normals with twice the face's area as length."""
    a, b, c = (vertices[faces[:, k]].T for k in range(3))
    b, c = b - a, c - a
    return np.stack([b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2],
                     b[0] * c[1] - b[1] * c[0]], axis=1)


def unit(vectors: Floats) -> Floats:
    """Unit vectors; vectors of length 0 stay."""
    lengths = np.linalg.norm(vectors, axis=1)
    return np.asarray(vectors / np.where(lengths > 0, lengths, 1)[:, None])


def _coarse_mesh(vertices: Floats, faces: Array, shown: Array) -> "tuple[Floats, Array]":
    """The coarse mesh for thumbnails: vertices in one cell of a grid become one vertex."""
    low = vertices[shown].min(axis=0)
    cell = float((vertices[shown].max(axis=0) - low).max()) / _CELLS
    if len(faces) > 5000 and cell > 0:
        grid = np.zeros((len(vertices), 3), np.int64)
        grid[shown] = (vertices[shown] - low) / cell
        keys = grid @ np.array([(_CELLS + 1) ** 2, _CELLS + 1, 1])
        first: Array = np.full((_CELLS + 1) ** 3, -1, np.int64)
        first[keys[shown[::-1]]] = shown[::-1]
        faces = first[keys[faces]]
        a, b, c = faces.T
        faces = faces[(a != b) & (b != c) & (c != a)]
    used, numbers = np.unique(faces, return_inverse=True)
    return vertices[used], numbers.reshape(-1, 3)
