"""The shaded surface of a picture, from a depth buffer, with the light of talweg-picture."""

from __future__ import annotations

from typing import Optional

import numpy as np

from . import _raster
from ._camera import Camera, normals_of, unit
from ._types import Array, Floats

_SAMPLES = 2  # samples of each pixel, in x and in y
MATERIAL = np.array([0.91, 0.85, 0.775])
BACKGROUND = np.array([0.965, 0.965, 0.96])
_SMOOTH = 0.8  # cosine of the angle between the normals of a vertex and of a face, below which the edge is
               # sharp


def _direction(*components: float) -> Floats:
    return np.asarray(np.array(components) / np.linalg.norm(components))


_KEY, _FILL = _direction(-0.45, 0.65, 0.70), _direction(0.80, 0.05, 0.55)
_HALFWAY = _direction(*(_KEY + [0, 0, 1]))


def _linear(color: Array) -> Floats:
    color = np.asarray(color, dtype=np.float64)
    return np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)


def _stored(light: Array) -> Array:
    light = np.clip(light, 0, 1)
    srgb = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    stored: Array = np.rint(255 * srgb).astype(np.uint8)
    return stored


class Surface:
    """The shaded mesh in the view of a camera.

    :param colors: sRGB in [0, 1], (n, 3) at vertices, or (m, 3) at faces; None: the colour of the material.
    """

    def __init__(self, vertices: Floats, faces: Array, camera: Camera,
                 colors: Optional[Floats] = None, colors_at_faces: bool = False) -> None:
        self.camera = camera
        self._fine = camera.times(_SAMPLES)
        self._points = self._fine.project(vertices)
        self._buffer = _raster.Buffer(self._fine.width, self._fine.height)
        self._buffer.draw(self._points, faces)
        self._pixels = np.flatnonzero(self._buffer.faces != _raster.NOTHING)
        self._shown, numbers = _compressed(self._buffer.faces[self._pixels], len(faces))
        self._face = numbers  # the face of each pixel, as an index into the shown faces
        self._corners = self._points[faces[self._shown]]
        self._normals = _corner_normals(self._points, faces, self._shown)
        self._colors = None
        if colors is not None:
            linear = _linear(colors)
            self._colors = (np.repeat(linear[self._shown][:, None], 3, axis=1) if colors_at_faces
                            else linear[faces[self._shown]])

    def image(self) -> Array:
        """(height, width, 3) bytes."""
        weights = self._weights()
        light = self._lit(weights) * self._edges(weights)[:, None]
        fine = np.empty((self._fine.height * self._fine.width, 3), np.float32)
        fine[:] = _linear(BACKGROUND)
        fine[self._pixels] = light
        shape = (self.camera.height, _SAMPLES, self.camera.width, _SAMPLES, 3)
        return _stored(fine.reshape(shape).mean(axis=(1, 3)))

    def hides(self, points: Floats) -> Array:
        """Whether the surface hides each of some points on it, (n,) booleans; False outside the frame.

        :param points: (n, 3) in the pixels of the camera.
        """
        fine = np.asarray(points) * _SAMPLES + [(_SAMPLES - 1) / 2, (_SAMPLES - 1) / 2, 0]
        at = np.rint(fine[:, :2]).astype(np.int64)
        farthest = np.full(len(fine), np.inf)
        for x in (-1, 0, 1):  # a neighbouring pixel may show the surface at another depth
            for y in (-1, 0, 1):
                column = np.clip(at[:, 0] + x, 0, self._fine.width - 1)
                row = np.clip(at[:, 1] + y, 0, self._fine.height - 1)
                depth = self._buffer.depths[row * self._fine.width + column]
                farthest = np.minimum(farthest, depth)
        return farthest > fine[:, 2] + 1.5 * _SAMPLES

    def _weights(self) -> Floats:
        """Barycentric coordinates of every pixel in its face."""
        x, y = self._pixels % self._fine.width, self._pixels // self._fine.width
        a, b, c = (self._corners[:, k, :2] for k in range(3))
        u, v = b - a, c - a
        area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        inverse = 1 / np.where(area != 0, area, np.inf)
        f = self._face
        x, y = x - a[f, 0], y - a[f, 1]
        second = np.clip((x * v[f, 1] - y * v[f, 0]) * inverse[f], 0, 1)
        third = np.clip((y * u[f, 0] - x * u[f, 1]) * inverse[f], 0, 1 - second)
        return np.asarray(np.stack([1 - second - third, second, third], axis=1), np.float32)

    def _mixed(self, values: Floats, weights: Floats) -> Floats:
        """Interpolates values of corners, (shown, 3, k), to every pixel."""
        values = values.astype(np.float32)
        result: Floats = weights[:, :1] * values[self._face, 0]
        for k in (1, 2):
            result += weights[:, k:k + 1] * values[self._face, k]
        return result

    def _lit(self, weights: Floats) -> Floats:
        normal = self._mixed(self._normals, weights)
        normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-20)[:, None]
        inside = normal[:, 2] < 0
        normal[inside] *= -1
        material = (_linear(MATERIAL) if self._colors is None
                    else self._mixed(self._colors, weights))
        wrapped = np.maximum(0, (normal @ _KEY + 0.25) / 1.25) ** 2
        up = (0.5 + 0.5 * normal[:, 1])[:, None]
        around = up * [0.36, 0.37, 0.40] + (1 - up) * [0.24, 0.21, 0.19]
        direct = (wrapped[:, None] * [0.86, 0.83, 0.77]
                  + np.maximum(0, normal @ _FILL)[:, None] * [0.13, 0.15, 0.20])
        light = material * (around + direct)
        light += 0.07 * np.maximum(0, normal @ _HALFWAY)[:, None] ** 28
        light *= 1 - 0.25 * (1 - normal[:, 2:]) ** 3
        light[inside] = (light * [0.50, 0.50, 0.56])[inside]
        return np.asarray(light)

    def _edges(self, weights: Floats) -> Floats:
        """Factors that darken pixels near edges of the mesh, if edges are long enough in the picture."""
        sides = self._corners[:, [1, 2, 0], :2] - self._corners[:, [2, 0, 1], :2]
        lengths = np.linalg.norm(sides, axis=2)  # of the side opposite each corner
        mean = float(lengths.mean()) / _SAMPLES if len(lengths) > 0 else 0.0
        strength = 0.42 * min(max((mean - 11) / 12, 0.0), 1.0)
        if strength == 0:
            return np.ones(len(weights))
        area = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
        heights = area[:, None] / np.maximum(lengths, 1e-12)
        away = (weights * heights[self._face]).min(axis=1)  # pixels from the nearest side
        return np.asarray(1 - strength * np.clip(1.2 - away / (0.5 * _SAMPLES), 0, 1))


def _compressed(faces: Array, count: int) -> "tuple[Array, Array]":
    """The vertices that faces use, ascending, and the faces as indices into them."""
    occurs = np.zeros(count, bool)
    occurs[faces] = True
    return np.flatnonzero(occurs), (np.cumsum(occurs) - 1)[faces]


def _corner_normals(points: Floats, faces: Array, shown: Array) -> Floats:
    """(shown, 3, 3), unit normals in the axes of the camera: the normals of the vertices; at sharp edges, of
    the faces."""
    flat = normals_of(points * [1, -1, 1], faces)
    flat[~np.isfinite(flat.sum(axis=1))] = 0
    at_vertices = np.stack([sum(np.bincount(faces[:, k], flat[:, x], len(points))
                                for k in range(3)) for x in range(3)], axis=1)
    flat, at_vertices = unit(flat), unit(at_vertices)
    sharp = np.zeros(len(points), bool)
    for k in range(3):
        corner = faces[:, k]
        sharp[corner[np.einsum("ij,ij->i", flat, at_vertices[corner]) < _SMOOTH]] = True
    corner = faces[shown]
    return np.where(sharp[corner][:, :, None], flat[shown][:, None], at_vertices[corner])
