"""Polygons become fans of triangles, as when Talweg reads a file."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from ._types import Array


def fans(corners: Array, sizes: Array) -> Tuple[Array, Array]:
    """Triangles (m, 3), and (m,) the polygon that each is of.

    :param corners: the polygons' vertices, one polygon after the other.
    :param sizes: (k,) how many corners each polygon has; those with fewer than three vanish.
    """
    triangles = np.maximum(np.asarray(sizes, dtype=np.int64) - 2, 0)
    polygons = np.repeat(np.arange(len(sizes)), triangles)
    first = (np.cumsum(sizes) - sizes)[polygons]
    second = first + 1 + np.arange(len(polygons)) - (np.cumsum(triangles) - triangles)[polygons]
    return np.stack([corners[first], corners[second], corners[second + 1]], axis=1), polygons
