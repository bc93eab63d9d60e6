"""Triangulates polygons in the same way as Talweg's readers of files."""

from __future__ import annotations

from typing import List, Optional, Tuple

import numpy as np

from ._types import Array

MOST_CORNERS = 500  # of a concave polygon: the search for ears is quadratic


def triangulated(points: Array, corners: Array, sizes: Array) -> Tuple[Array, Array]:
    """Triangles (m, 3), and the polygon of each triangle (m,).

    A polygon becomes the fan from its first corner if the fan covers it, as it does for convex polygons. Ears
    are clipped from other polygons of up to 500 corners. A polygon that crosses itself stays a fan.

    :param points: (n, 3) positions of the vertices.
    :param corners: the polygons' vertices, one polygon after the other.
    :param sizes: (k,) the number of corners of each polygon; polygons with fewer than three corners vanish.
    """
    points = np.asarray(points)
    triangles, polygons = _fans(corners, sizes)
    if not len(triangles) or triangles.min() < 0 or triangles.max() >= len(points):
        return triangles, polygons  # indices out of range are reported when the mesh is opened
    begins = np.cumsum(sizes) - sizes
    for polygon, normal in _uncovered(points, triangles, polygons):
        around = np.asarray(corners[begins[polygon]:begins[polygon] + sizes[polygon]])
        ears = _ears(_in_plane(np.asarray(points[around], dtype=np.float64), normal))
        if ears is not None:
            triangles[polygons == polygon] = around[ears]
    return triangles, polygons


def _fans(corners: Array, sizes: Array) -> Tuple[Array, Array]:
    triangles = np.maximum(np.asarray(sizes, dtype=np.int64) - 2, 0)
    polygons = np.repeat(np.arange(len(sizes)), triangles)
    first = (np.cumsum(sizes) - sizes)[polygons]
    second = first + 1 + np.arange(len(polygons)) - (np.cumsum(triangles) - triangles)[polygons]
    return np.stack([corners[first], corners[second], corners[second + 1]], axis=1), polygons


def _uncovered(points: Array, triangles: Array, polygons: Array) -> List[Tuple[int, Array]]:
    """Polygons whose fan has an inverted triangle, with their normals (Newell's method)."""
    a, b, c = (np.asarray(points[triangles[:, k]], dtype=np.float64) for k in range(3))
    across = np.cross(b - a, c - a)
    normals = np.zeros((polygons[-1] + 1, 3))
    np.add.at(normals, polygons, across)
    turned = np.einsum("ij,ij->i", across, normals[polygons])
    limit = -1e-12 * np.einsum("ij,ij->i", normals, normals)[polygons]
    return [(int(k), normals[k]) for k in np.unique(polygons[turned < limit])]


def _in_plane(corners: Array, normal: Array) -> Array:
    corners = corners - corners[0]
    normal = normal / np.linalg.norm(normal)
    x = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    x /= np.linalg.norm(x)
    size = np.abs(corners).max()
    return np.asarray(np.stack([corners @ x, corners @ np.cross(normal, x)], axis=1) / size)


def _turn(a: Array, b: Array, c: Array) -> Array:
    """Twice the signed area of the triangle a, b, c; positive for a left turn."""
    return np.asarray((b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (
        b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0]))


def _ears(places: Array) -> Optional[Array]:
    """Corners (n - 2, 3) of triangles that fill a counterclockwise polygon; None if no triangulation is
    found, or for too many corners."""
    if len(places) > MOST_CORNERS:
        return None
    around, ears = list(range(len(places))), []
    at = misses = 0
    while len(around) > 3 and misses < len(around):
        at %= len(around)
        ear = [around[at - 1], around[at], around[(at + 1) % len(around)]]
        if _is_ear(places, ear, around):
            ears.append(ear)
            del around[at]
            misses = 0
        else:
            misses += 1
        at += 1
    if len(around) > 3 or _turn(*places[around]) < -1e-12:
        return None
    return np.array([*ears, around])


def _is_ear(places: Array, ear: List[int], around: List[int]) -> bool:
    a, b, c = places[ear]
    if _turn(a, b, c) <= 1e-12:
        return False
    others = places[[k for k in around if k not in ear]]
    others = others[~np.any(np.all(others[:, None] == places[ear][None], axis=2), axis=1)]
    inside = (_turn(a, b, others) >= -1e-12) & (_turn(b, c, others) >= -1e-12) & (
        _turn(c, a, others) >= -1e-12)
    return not np.any(inside)
