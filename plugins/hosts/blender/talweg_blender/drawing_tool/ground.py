"""Points of the surface: where a ray meets it, and what is nearest to a position."""

import numpy as np

from .lines import Point


class Ground:
    """The surface as Blender's own trees know it; they are made once and are fast.

    :param shown: gives the evaluated object whenever it is asked, since Blender replaces it.
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
        """Whether nothing of the surface is before it, up to so many pixels of its own size."""
        origin, direction = view.ray(view.project([position])[0])
        found, place, _, _ = self._shown().ray_cast(origin.tolist(), direction.tolist())
        if not found:
            return True
        behind = np.dot(np.subtract(position, place), direction)
        return behind <= max(pixels * view.pixel_at(position), min(self.surface.edge, self.surface.size / 200))

    def at(self, face, barycentric, exact=False):
        """The Point of given coordinates."""
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
    """Barycentrics of the nearest point, and how far that is."""
    a, b, c = corners
    solved, *_ = np.linalg.lstsq(np.stack([b - a, c - a], -1), np.subtract(position, a), rcond=None)
    weights = np.clip([1 - solved.sum(), *solved], 0, None)
    weights /= weights.sum() or 1
    return tuple(weights), float(np.linalg.norm(weights @ corners - position))
