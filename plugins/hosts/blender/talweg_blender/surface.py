"""The surface that is worked on: with modifiers and shape keys as it is shown, or the mesh itself."""

import numpy as np
from mathutils.bvhtree import BVHTree

from . import drawings, session
from .package import talweg


def is_changed(obj):
    """Whether the surface that is shown may be another one than the mesh."""
    return obj.data.shape_keys is not None or any(one.show_viewport for one in obj.modifiers)


class Surface:
    """One of both, as arrays and as a place to measure from."""

    def __init__(self, context, obj, as_shown):
        """:raises talweg.BadMesh: if there are no faces."""
        changed = is_changed(obj)
        self._evaluated = None  # what is hidden is not evaluated
        if obj.mode == "OBJECT" and obj.visible_get() and (as_shown or not changed):
            self._evaluated = obj.evaluated_get(context.evaluated_depsgraph_get())
        if changed and self._evaluated is not None:
            self.arrays = drawings.MeshArrays(self._evaluated.to_mesh())
            self._evaluated.to_mesh_clear()
        else:
            self.arrays = drawings.MeshArrays(obj.data)
        if not len(self.arrays.triangles):
            raise talweg.BadMesh("The mesh has no faces.")
        self.edge = session.measured(self.arrays, "edge", lambda: mean_edge(self.arrays))
        self.size = float(np.linalg.norm(np.ptp(self.arrays.vertices.astype(float), axis=0)))
        self._tree = None

    def farthest(self, points):
        """How far the farthest of these points lies from the surface."""
        return session.measured(self.arrays, drawings.key_of("points", points), lambda: max(
            (self._distance(point) for point in points.tolist()), default=0.0))

    def _distance(self, point):
        if self._evaluated is not None:
            found, nearest = self._evaluated.closest_point_on_mesh(point)[:2]
            return float(np.linalg.norm(np.subtract(nearest, point))) if found else 0.0
        if self._tree is None:
            self._tree = BVHTree.FromPolygons(self.arrays.vertices.tolist(), self.arrays.triangles.tolist())
        return self._tree.find_nearest(point)[3]

    @property
    def far(self):
        """What is farther away than this was hardly meant to lie here."""
        return min(3 * self.edge, self.size / 30)

    @property
    def too_far(self):
        """What is farther away than this is no drawing on this surface."""
        return min(10 * self.edge, self.size / 8)

    def told(self, distance):
        """The distance in both units."""
        return f"up to {distance:.3g} away from the mesh, {distance / self.edge:.2g} mean edges"


def mean_edge(arrays):
    """Over all corners of all triangles, in the object's own units; 0 without triangles."""
    corners = arrays.vertices[arrays.triangles].astype(float)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return float(sides.mean()) if sides.size else 0.0
