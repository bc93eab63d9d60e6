"""A surface with its opened mesh. A new drawing or a new value repeats only its own stage of the work."""

import hashlib

import bpy
import numpy as np
from mathutils.bvhtree import BVHTree

from . import lengths
from .package import talweg

#: The number of results that a surface keeps, so that a curve object can be replaced by its exact result.
_MOST = 16


class Surface:
    """Triangles as arrays, Blender's object for distances, and the opened meshes."""

    def __init__(self, arrays):
        """:raises talweg.BadMesh: if the mesh has no faces."""
        if not len(arrays.triangles):
            raise talweg.BadMesh("The mesh has no faces.")
        self.arrays = arrays
        #: Blender's evaluated object, if it exists at present. Its search tree measures distances faster than
        #: numpy.
        self.shown = None
        self.edge = mean_edge(arrays)
        self.size = float(np.linalg.norm(np.ptp(arrays.vertices.astype(float), axis=0)))
        self._tree = None
        self._opened = {}  # (talweg.Mesh, talweg.Workspace), by whether the mesh is repaired
        self._measures = {}
        self._known = {}  # results by the keys of their drawings

    @property
    def triangle_count(self):
        return len(self.arrays.triangles)

    @property
    def fingerprint(self):
        """A hash that is equal for equal meshes, also in another session of Blender."""
        return self.measured("fingerprint", lambda: hashlib.sha1(
            self.arrays.vertices.tobytes() + self.arrays.triangles.tobytes()).hexdigest())

    def mesh(self, repair=False):
        """The talweg.Mesh, repaired on request. :raises talweg.BadMesh: if it is not a surface."""
        return self._with_workspace(repair)[0]

    def _with_workspace(self, repair):
        if repair not in self._opened:
            mesh = talweg.Mesh(self.arrays.vertices, self.arrays.triangles, repair=repair)
            self._opened[repair] = mesh, mesh.workspace()
        return self._opened[repair]

    def smooth(self, curves, parameters, repair=False, progress=None, key="", **wanted):
        """The talweg.Result of these curves. Stages whose input is unchanged are not repeated. Raises
        talweg.Error.

        :param key: the key of the drawing, under which the result is kept for known_curves().
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
        """The curves of the kept results, in double precision; curve objects have them rounded."""
        return [curve for result in self._known.values() for curve in result.curves]

    def measured(self, what, measure):
        """The result of measure(), kept under the key ``what``: at a million faces a measure takes as long as
        a step of a slider."""
        if what not in self._measures:
            self._measures[what] = measure()
        return self._measures[what]

    def farthest(self, points):
        """The distance from the surface of the farthest point."""
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
        """A distance beyond which a drawing was hardly meant for this surface."""
        return min(3 * self.edge, self.size / 30)

    @property
    def too_far(self):
        """A distance beyond which a drawing is refused on this surface."""
        return min(10 * self.edge, self.size / 8)

    def distance_text(self, distance):
        """The distance in scene units and in mean edges, as a text."""
        return (f"up to {lengths.with_unit(bpy.context, distance)} away from the mesh, "
                f"{lengths.number(distance / self.edge, 2)} mean edges")


def mean_edge(arrays):
    """The mean length of the sides of all triangles, in the object's units; 0 without triangles."""
    corners = arrays.vertices[arrays.triangles].astype(float)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return float(sides.mean()) if sides.size else 0.0
