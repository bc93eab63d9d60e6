"""Curve files have the driver's bytes, and can be read again."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg

FORMATS = ("json", "obj", "ply", "vtp", "vtk", "mrk.json")


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        cls.drawn = support.staircase()
        cls.curve = talweg.smooth((cls.vertices, cls.faces), cls.drawn).curve

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_spaces(self):
        """A mesh has its space; curves in another space are converted, with a note."""
        corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        talweg.write_mesh(self.folder / "plain.ply", (corners, [[0, 2, 1], [0, 1, 3], [1, 2, 3],
                                                               [2, 0, 3]]))
        plain = (self.folder / "plain.ply").read_bytes()
        noted = plain.replace(b"1.0\n", b"1.0\ncomment 3D Slicer output. SPACE=RAS\n", 1)
        (self.folder / "ras.ply").write_bytes(noted)
        self.assertEqual(talweg.read_mesh(self.folder / "plain.ply").frame, "")
        mesh = talweg.read_mesh(self.folder / "ras.ply")
        self.assertEqual(mesh.frame, "RAS")
        talweg.write_mesh(self.folder / "again.ply", mesh)
        self.assertIn(b"comment SPACE=RAS\n", (self.folder / "again.ply").read_bytes())
        path = self.folder / "lps.mrk.json"
        path.write_text('{"markups": [{"type": "Curve", "controlPoints": [{"position": [1, 2, 3]},'
                        ' {"position": [4, 5, 6]}]}]}')
        with self.assertLogs("talweg", "WARNING") as told:
            curve, = talweg.read_curves(path, mesh.frame)
        self.assertIn("turned from LPS to RAS", told.output[0])
        np.testing.assert_array_equal(curve.positions, [[-1, -2, 3], [-4, -5, 6]])
        np.testing.assert_array_equal(talweg.read_curves(path)[0].positions, [[1, 2, 3], [4, 5, 6]])

    def test_units(self):
        text = ('{"markups": [{"type": "Curve", "coordinateUnits": "cm", "controlPoints": '
                '[{"position": [1, 2, 3]}, {"position": [4, 5, 6]}]}]}')
        path = self.folder / "cm.mrk.json"
        path.write_text(text)
        expected = np.array([[1, 2, 3], [4, 5, 6]], float)
        for unit, scale in (("cm", 1), ("mm", 10), ("um", 10000)):
            curve, = talweg.read_curves(path, mesh_unit=unit)
            np.testing.assert_allclose(curve.positions, scale * expected, rtol=1e-15)
        np.testing.assert_array_equal(talweg.read_curves(path)[0].positions, 10 * expected)
        with self.assertRaisesRegex(talweg.BadUsage, "furlong"):
            talweg.read_curves(path, mesh_unit="furlong")
        talweg.write_curves(path, self.curve, mesh_unit="um")
        self.assertIn('"coordinateUnits": "um"', path.read_text())

    def test_the_drivers_bytes(self):
        support.write_obj(self.folder / "mesh.obj", self.vertices, self.faces)
        drawn = talweg.draw((self.vertices, self.faces), [305, 1820, 3055], exact=False)
        talweg.write_curves(self.folder / "drawn.txt", drawn)
        np.testing.assert_array_equal(np.loadtxt(self.folder / "drawn.txt"), drawn.vertices)
        outputs = [f"driver.{name}" for name in FORMATS]
        support.driver(self.folder, "smooth", "mesh.obj", "--curve", "drawn.txt",
                       *[word for output in outputs for word in ("-o", output)])
        curve = talweg.smooth((self.vertices, self.faces), drawn).curve
        for name in FORMATS:
            talweg.write_curves(self.folder / f"ours.{name}", curve)
            self.assertEqual((self.folder / f"ours.{name}").read_bytes(),
                             (self.folder / f"driver.{name}").read_bytes(), name)

    def test_way_points_of_files(self):
        support.write_obj(self.folder / "mesh.obj", self.vertices, self.faces)
        drawn = talweg.draw((self.vertices, self.faces), [305, 1820, 3055], straight=False)
        np.testing.assert_array_equal(np.flatnonzero(drawn.exact == 0)[[0, -1]],
                                      [0, len(drawn) - 1])
        curve = talweg.smooth((self.vertices, self.faces), drawn).curve
        talweg.write_curves(self.folder / "ours.json", curve)
        for name in ("json", "vtp", "vtk"):
            talweg.write_curves(self.folder / f"drawn.{name}", drawn)
            read, = talweg.read_curves(self.folder / f"drawn.{name}")
            np.testing.assert_array_equal(read.exact, drawn.exact)
            support.driver(self.folder, "smooth", "mesh.obj", "--curve", f"drawn.{name}",
                           "-o", "driver.json")
            self.assertEqual((self.folder / "ours.json").read_bytes(),
                             (self.folder / "driver.json").read_bytes(), name)
        rough = talweg.smooth((self.vertices, self.faces), drawn, points="rough").curve
        self.assertNotEqual(len(rough.positions), 0)
        self.assertFalse(np.any(np.all(np.isclose(rough.positions, self.vertices[1820]), axis=1)))
        self.assertTrue(np.any(np.all(np.isclose(curve.positions, self.vertices[1820]), axis=1)))

    def test_round_trips(self):
        mesh = talweg.Mesh(self.vertices, self.faces)
        expected = mesh.smooth(self.curve).curve.positions
        for name in FORMATS:
            path = self.folder / f"curve.{name}"
            talweg.write_curves(str(path), [self.curve])
            back = talweg.read_curves(path)
            self.assertEqual((len(back), len(back[0]), back[0].closed),
                             (1, len(self.curve), False), name)
            if name == "json":
                np.testing.assert_array_equal(back[0].faces, self.curve.faces)
                np.testing.assert_array_equal(back[0].barycentrics, self.curve.barycentrics)
                np.testing.assert_array_equal(mesh.smooth(back).curve.positions, expected)

    def test_sets_and_loops(self):
        vertices, faces = support.torus()
        drawn = [talweg.Curve(support.ring(column=k), closed=True) for k in (5, 30)]
        result = talweg.smooth((vertices, faces), drawn)
        talweg.write_curves(self.folder / "two.json", result.curves)
        self.assertEqual([curve.closed for curve in talweg.read_curves(self.folder / "two.json")],
                         [True, True])
        (self.folder / "ring.txt").write_text("\n".join(map(str, [1, 2, 3, 1])))
        ring = talweg.read_curves(self.folder / "ring.txt")[0]
        self.assertEqual((ring.vertices.tolist(), ring.closed), ([1, 2, 3], True))

    def test_errors(self):
        with self.assertRaisesRegex(talweg.BadFile, "missing.json"):
            talweg.read_curves(self.folder / "missing.json")
        (self.folder / "bad.txt").write_text("1\ntwo\n")
        with self.assertRaisesRegex(talweg.BadFile, "bad.txt.*2.*two"):
            talweg.read_curves(self.folder / "bad.txt")
        with self.assertRaisesRegex(talweg.Error, "xyz"):
            talweg.write_curves(self.folder / "curve.xyz", self.curve)
        with self.assertRaisesRegex(talweg.BadFile, "nowhere"):
            talweg.write_curves(self.folder / "nowhere/curve.json", self.curve)
        with self.assertRaisesRegex(talweg.BadUsage, "face, barycentrics and a position"):
            talweg.write_curves(self.folder / "curve.json", talweg.Curve(self.drawn))
        with self.assertRaises(talweg.Error):
            talweg.write_curves(self.folder / "curve.txt", self.curve)  # some points are not vertices
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["bad.txt"])


if __name__ == "__main__":
    unittest.main()
