"""Points of the surface: the first on a ray, and the nearest to a position."""

import numpy as np

from .lines import Point


class Ground:
    """Points of the surface, found by Blender's own search trees, which are quick and made once.

    :param shown: a function that returns the evaluated object; Blender replaces the object now and then.
    """

    def __init__(self, surface, shown):
        self.surface = surface
        self._shown = shown

    def hit(self, ray, exact):
        """The Point where a ray (origin, direction) meets the surface first, or None."""
        found, position, _, polygon = self._shown().ray_cast(*(list(map(float, part)) for part in ray))
        return self._point(position, polygon, exact) if found else None

    def nearest(self, position, exact):
        """The Point nearest to a position."""
        found, place, _, polygon = self._shown().closest_point_on_mesh(list(map(float, position)))
        return self._point(place, polygon, exact) if found else None

    def sees(self, view, position, pixels=6):
        """Whether the eye sees the position: the surface does not hide it. Parts of the surface at most
        ``pixels`` in front of the position do not count."""
        origin, direction = view.ray(view.project([position])[0])
        found, place, _, _ = self._shown().ray_cast(origin.tolist(), direction.tolist())
        if not found:
            return True
        behind = np.dot(np.subtract(position, place), direction)
        return behind <= max(pixels * view.pixel_at(position), min(self.surface.edge, self.surface.size / 200))

    def at(self, face, barycentric, exact=False):
        """The Point with these barycentric coordinates."""
        arrays = self.surface.arrays
        corners = arrays.vertices[arrays.triangles[face]].astype(float)
        return Point(int(face), tuple(map(float, barycentric)), tuple(np.asarray(barycentric) @ corners), exact)

    def _point(self, position, polygon, exact):
        arrays = self.surface.arrays
        first, last = np.searchsorted(arrays.polygons, [polygon, polygon + 1])
        best = min((_in_triangle(arrays.vertices[arrays.triangles[face]].astype(float), position) + (face,)
                    for face in range(first, last)), key=lambda one: one[1])
        return self.at(best[2], best[0], exact)


def _in_triangle(corners, position):
    """Barycentrics of the point of the triangle nearest to ``position``, and its distance."""
    a, b, c = corners
    solved, *_ = np.linalg.lstsq(np.stack([b - a, c - a], -1), np.subtract(position, a), rcond=None)
    weights = np.clip([1 - solved.sum(), *solved], 0, None)
    weights /= weights.sum() or 1
    return tuple(weights), float(np.linalg.norm(weights @ corners - position))
