"""Way-points: marks by draw() and of curves, and their effect on smooth()."""

import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg

THROUGH = [305, 1820, 3055]


class WayPoints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        vertices, faces = support.hills()
        cls.vertices = vertices
        cls.mesh = talweg.Mesh(vertices, faces)
        cls.drawing_mesh = talweg.Mesh(vertices, faces, plugin="talweg.draw")
        cls.drawn = cls.drawing_mesh.draw(THROUGH, straight=False)
        cls.rough = cls.drawing_mesh.draw(THROUGH, exact=False)
        cls.result = cls.mesh.smooth(cls.drawn).curve

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def equal(self, ours, theirs):
        np.testing.assert_array_equal(ours.faces, theirs.faces)
        np.testing.assert_array_equal(ours.barycentrics, theirs.barycentrics)

    def passes(self, curve, vertex):
        return (curve.positions == self.vertices[vertex]).all(axis=1).any()

    def smooth(self, curve, **parameters):
        return self.mesh.smooth(curve, **parameters).curve

    def test_drawing_makes_them(self):
        exact = np.flatnonzero(self.drawn.exact == 0)
        self.assertEqual(self.drawn.vertices[exact].tolist(), THROUGH)
        self.assertEqual(np.unique(self.drawn.exact).tolist(), [-1, 0])
        self.assertNotIn("exact", self.drawn.fields)
        self.assertIsNone(self.rough.exact)
        self.equal(self.rough, self.drawn)
        vertices, faces = support.hills()
        self.assertIsNone(talweg.draw((vertices, faces), THROUGH, exact=False).exact)
        np.testing.assert_array_equal(talweg.draw((vertices, faces), THROUGH, straight=False).exact,
                                      self.drawn.exact)

    def test_ridges_move_them(self):
        side = np.arange(31)
        x, y = (a.ravel() for a in np.meshgrid(side, side))
        vertices = np.column_stack([x, y, -0.6 * abs(y - 15.0)])
        corner = (side[:-1, None] * 31 + side[None, :-1]).ravel()
        faces = np.concatenate([corner[:, None] + [0, 1, 32], corner[:, None] + [0, 32, 31]])
        through = [13 * 31 + 3, 16 * 31 + 15, 13 * 31 + 27]
        moved = talweg.draw((vertices, faces), through, ridges=1)
        inner = moved.positions[(moved.positions[:, 0] > 5) & (moved.positions[:, 0] < 25)]
        np.testing.assert_array_equal(inner[:, 1], 15)  # docs/ridges.md: ends may lie beside the ridge
        self.assertEqual((moved.exact == 0).sum(), 3)
        result = talweg.smooth((vertices, faces), talweg.draw((vertices, faces), through, exact=False),
                               ridges=1, ridge_kind="convex")
        self.assertGreater(result.total.ridge_moved, 0.75)
        along = result.curve.positions[result.curve.positions[:, 0] < 22]
        np.testing.assert_allclose(along[:, 1], 15, atol=0.2)  # ends may lie beside the ridge
        with self.assertRaises(talweg.BadUsage):
            talweg.draw((vertices, faces), through, ridges=2)

    def test_smoothing_passes_them(self):
        for vertex in THROUGH:
            self.assertTrue(self.passes(self.result, vertex), vertex)
        stroke = self.smooth(self.rough)
        self.assertFalse(self.passes(stroke, THROUGH[1]))
        self.equal(self.smooth(self.drawn, points="rough"), stroke)
        self.equal(self.smooth(self.rough, exact=THROUGH), self.result)
        self.assertIsNone(self.result.exact)

    def test_every_form(self):
        at = np.flatnonzero(self.drawn.exact == 0)
        some = np.zeros(len(self.drawn), bool)
        some[at] = True
        tolerances = np.where(some, 0, -1)
        for exact in (some, list(some), tolerances, tolerances.astype(float).tolist()):
            given = talweg.Curve(self.drawn.vertices, exact=exact)
            self.equal(self.smooth(given), self.result)
        every = self.smooth(talweg.Curve(self.drawn.vertices, exact=True))
        self.assertTrue(all(self.passes(every, vertex) for vertex in self.drawn.vertices))
        self.equal(self.smooth(self.rough, points="exact"), every)
        for nothing in (None, False):
            self.equal(self.smooth(talweg.Curve(self.drawn.vertices, exact=nothing)),
                       self.smooth(self.rough))
        near = self.smooth(talweg.Curve(self.drawn.vertices, exact=np.where(some, 0.5, -1)))
        self.equal(self.smooth(self.drawn, tolerance=0.5), near)
        self.assertFalse(self.passes(near, THROUGH[1]))
        painted = np.where(some, 0.0, -2)  # a stroke through clicked points
        self.assertGreater(len(self.smooth(talweg.Curve(self.drawn.vertices, exact=painted))), 10)

    def test_bad_values_of_exact(self):
        n = len(self.drawn)
        for exact, words in (([True], rf"must be True, a tolerance, or \({n},\)"),
                             ("yes", "must be True, a tolerance"),
                             (np.full((n, 2), 0.0), "must be True, a tolerance")):
            with self.assertRaisesRegex(talweg.BadCurve, words):
                self.smooth(talweg.Curve(self.drawn.vertices, exact=exact))
        for exact in (-0.5, float("nan"), float("inf"), -4.0):
            with self.assertRaisesRegex(talweg.BadUsage, "field exact has .* at point 0"):
                self.smooth(talweg.Curve(self.drawn.vertices, exact=exact))
        with self.assertRaisesRegex(talweg.BadUsage, "given, exact, rough"):
            self.smooth(self.drawn, points="sharp")
        with self.assertRaises(talweg.Error):
            self.smooth(self.drawn, exact=[7])  # 7 is not a vertex of the curve

    def test_files_and_the_driver(self):
        support.write_obj(self.folder / "mesh.obj", *support.hills())
        support.driver(self.folder, "draw", "mesh.obj", "--through", ",".join(map(str, THROUGH)),
                       "--edges", "-o", "driver.json", "-o", "driver.vtp", "-o", "driver.vtk")
        for name in ("json", "vtp", "vtk"):
            talweg.write_curves(self.folder / f"ours.{name}", self.drawn)
            self.assertEqual((self.folder / f"ours.{name}").read_bytes(),
                             (self.folder / f"driver.{name}").read_bytes(), name)
            back, = talweg.read_curves(self.folder / f"driver.{name}")
            np.testing.assert_array_equal(back.exact, self.drawn.exact)
            self.equal(self.smooth(back), self.result)
        talweg.write_curves(self.folder / "rough.json", self.rough)
        self.assertIsNone(talweg.read_curves(self.folder / "rough.json")[0].exact)
        support.driver(self.folder, "smooth", "mesh.obj", "--curve", "driver.json", "-o",
                       "smooth.json")
        (_, faces, barycentrics, _), = support.driver_curves(self.folder / "smooth.json")
        np.testing.assert_array_equal(faces, self.result.faces)
        np.testing.assert_array_equal(barycentrics, self.result.barycentrics)

    def test_control_points_of_slicer(self):
        def read(indices):
            controls = [{"position": self.vertices[i].tolist()} for i in indices]
            path = self.folder / "a.mrk.json"
            path.write_text(json.dumps({"markups": [{"type": "Curve", "controlPoints": controls}]}))
            return talweg.read_curves(path)
        few = read(THROUGH)
        self.assertEqual(few[0].exact.tolist(), [-3, -3, -3])
        result = self.mesh.smooth(few)
        self.assertTrue(self.passes(result.curve, THROUGH[1]))
        dense = self.mesh.smooth(read(self.drawn.vertices))
        self.assertFalse(self.passes(dense.curve, THROUGH[1]))
        self.assertIn("taken as a stroke", " ".join(dense.total.warnings))

    def test_a_bound_does_not_apply(self):
        bounded = self.mesh.smooth(self.drawn, max_deviation=0.1)
        self.equal(bounded.curve, self.result)
        self.assertIn("largest deviation does not apply", " ".join(bounded.total.warnings))


if __name__ == "__main__":
    unittest.main()
