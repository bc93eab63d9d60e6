"""Meshes of other packages, by objects with the same members, and by the packages where installed."""

import tempfile
import types
import unittest
from pathlib import Path

import numpy as np

import support
import talweg


class Objects(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        cls.drawn = support.staircase()
        cls.expected = talweg.smooth((cls.vertices, cls.faces), cls.drawn).curve.positions

    def same(self, mesh):
        np.testing.assert_array_equal(talweg.Mesh(mesh).smooth(self.drawn).curve.positions,
                                      self.expected)

    def test_as_trimesh_looks(self):
        self.same(types.SimpleNamespace(vertices=self.vertices, faces=self.faces))

    def test_as_meshio_looks(self):
        half = len(self.faces) // 2
        blocks = [types.SimpleNamespace(type="line", data=np.array([[0, 1]])),
                  types.SimpleNamespace(type="triangle", data=self.faces[:half]),
                  types.SimpleNamespace(type="triangle", data=self.faces[half:])]
        self.same(types.SimpleNamespace(points=self.vertices, cells=blocks))
        with self.assertRaisesRegex(talweg.BadMesh, "no triangles"):
            talweg.Mesh(types.SimpleNamespace(points=self.vertices, cells=blocks[:1]))

    def test_polygons_become_fans_as_the_driver_makes_them(self):
        n = 60
        a = np.arange(n * n).reshape(n, n)[:-1, :-1].ravel()
        quads = np.stack([a, a + n, a + n + 1, a + 1], -1)
        mesh = types.SimpleNamespace(
            points=self.vertices, cells=[types.SimpleNamespace(type="quad", data=quads)])
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            support.write_obj(folder / "mesh.obj", self.vertices, [])
            with open(folder / "mesh.obj", "a", encoding="ascii") as out:
                for quad in (quads + 1).tolist():
                    out.write("f %d %d %d %d\n" % tuple(quad))
            (folder / "drawn.txt").write_text("\n".join(map(str, self.drawn)))
            support.driver(folder, "smooth", "mesh.obj", "--curve", "drawn.txt", "-o", "out.json")
            _, faces, barycentrics, positions = support.driver_curves(folder / "out.json")[0]
        curve = talweg.Mesh(mesh).smooth(self.drawn).curve
        np.testing.assert_array_equal(curve.faces, faces)
        np.testing.assert_array_equal(curve.barycentrics, barycentrics)
        np.testing.assert_array_equal(curve.positions, positions)

    def test_concave_polygons_are_triangulated_inside(self):
        points = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]], float)
        for first in range(6):  # an L of area 3
            corners = np.roll(np.arange(6), first)[None]
            mesh = talweg.Mesh(types.SimpleNamespace(
                points=points, cells=[types.SimpleNamespace(type="polygon", data=corners)]))
            a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
            areas = np.cross(b - a, c - a)[:, 2] / 2
            self.assertEqual(len(areas), 4)
            self.assertTrue(np.all(areas > 0))
            self.assertEqual(areas.sum(), 3)

    def test_meshio(self):
        try:
            import meshio  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("no meshio (Debian: python3-meshio)")
        with tempfile.TemporaryDirectory() as folder:
            support.write_obj(Path(folder) / "mesh.obj", self.vertices, self.faces)
            self.same(meshio.read(Path(folder) / "mesh.obj"))

    def test_trimesh(self):
        try:
            import trimesh  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("no trimesh (pip install trimesh)")
        self.same(trimesh.Trimesh(self.vertices, self.faces, process=False))


if __name__ == "__main__":
    unittest.main()
