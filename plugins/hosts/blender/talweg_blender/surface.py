"""The surface that is worked on, opened once: of it a new drawing or value costs only its stage."""

import hashlib

import bpy
import numpy as np
from mathutils.bvhtree import BVHTree

from . import lengths
from .package import talweg

#: So many results are known on a surface, so that curve objects are exactly what they show.
_MOST = 16


class Surface:
    """Triangles as arrays, a place to measure from, and what is opened on them."""

    def __init__(self, arrays):
        """:raises talweg.BadMesh: if there are no faces."""
        if not len(arrays.triangles):
            raise talweg.BadMesh("The mesh has no faces.")
        self.arrays = arrays
        #: Blender's own evaluated object, where there is one now: it measures faster than we do.
        self.shown = None
        self.edge = mean_edge(arrays)
        self.size = float(np.linalg.norm(np.ptp(arrays.vertices.astype(float), axis=0)))
        self._tree = None
        self._opened = {}  # by how it is repaired: (talweg.Mesh, talweg.Workspace)
        self._measures = {}
        self._known = {}  # results by the key of their drawing

    @property
    def triangle_count(self):
        return len(self.arrays.triangles)

    @property
    def fingerprint(self):
        """The same for the same mesh, also after Blender was closed."""
        return self.measured("fingerprint", lambda: hashlib.sha1(
            self.arrays.vertices.tobytes() + self.arrays.triangles.tobytes()).hexdigest())

    def mesh(self, repair=False):
        """The talweg.Mesh. :raises talweg.BadMesh: if it is no surface."""
        return self._with_workspace(repair)[0]

    def _with_workspace(self, repair):
        if repair not in self._opened:
            mesh = talweg.Mesh(self.arrays.vertices, self.arrays.triangles, repair=repair)
            self._opened[repair] = mesh, mesh.workspace()
        return self._opened[repair]

    def smooth(self, curves, parameters, repair=False, progress=None, key="", **wanted):
        """A talweg.Result; what is the same as before is not done anew. Raises talweg.Error.

        :param key: of the drawing; curve objects that show this result are known by it.
        :param wanted: point_fields.
        """
        workspace = self._with_workspace(repair)[1]
        workspace.set_curves(curves)
        result = workspace.smooth(progress=progress, **parameters, **wanted)
        self.know(key, result)
        return result

    def know(self, key, result):
        self._known.pop(key, None)
        self._known[key] = result
        while len(self._known) > _MOST:
            self._known.pop(next(iter(self._known)))

    def known_curves(self):
        """Those that were made last, which may have been rounded in curve objects."""
        return [curve for result in self._known.values() for curve in result.curves]

    def measured(self, what, measure):
        """measure(), or what it gave before: with a million faces it takes as long as a slider's step."""
        if what not in self._measures:
            self._measures[what] = measure()
        return self._measures[what]

    def farthest(self, points):
        """How far the farthest of these points lies from the surface."""
        return self.measured(("far", points.tobytes()), lambda: max(
            (self._distance(point) for point in points.tolist()), default=0.0))

    def _distance(self, point):
        if self.shown is not None:
            found, nearest = self.shown.closest_point_on_mesh(point)[:2]
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
        return (f"up to {lengths.told(bpy.context, distance)} away from the mesh, "
                f"{lengths.number(distance / self.edge, 2)} mean edges")


def mean_edge(arrays):
    """Over all corners of all triangles, in the object's own units; 0 without triangles."""
    corners = arrays.vertices[arrays.triangles].astype(float)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return float(sides.mean()) if sides.size else 0.0
