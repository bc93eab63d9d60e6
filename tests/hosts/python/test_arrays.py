"""Layouts and types of arrays: passed without a copy where possible, always with the same result."""

import unittest

import numpy as np

import support
import talweg
from talweg import _arrays


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        cls.drawn = support.staircase()
        cls.expected = talweg.smooth((cls.vertices, cls.faces), cls.drawn).curve.positions

    def same(self, vertices, faces, drawn=None, expected=None):
        result = talweg.smooth((vertices, faces), self.drawn if drawn is None else drawn)
        np.testing.assert_array_equal(result.curve.positions,
                                      self.expected if expected is None else expected)

    def test_integers_of_all_kinds(self):
        for kind in ("i2", "i4", "i8", "u2", "u4", "u8", ">i4", ">i8", ">u2"):
            with self.subTest(kind):
                self.same(self.vertices, self.faces.astype(kind), self.drawn.astype(kind))

    def test_single_precision_is_what_the_rounded_mesh_gives(self):
        rounded = self.vertices.astype(np.float32)
        expected = talweg.smooth((rounded.astype(np.float64), self.faces), self.drawn).curve.positions
        self.same(rounded, self.faces, expected=expected)
        self.same(rounded.astype(">f4"), self.faces, expected=expected)
        self.assertFalse(np.array_equal(expected, self.expected))

    def test_layouts(self):
        wide = np.full((len(self.vertices), 7), np.nan)
        wide[:, 2:5] = self.vertices
        twice = np.repeat(self.faces, 2, axis=0)
        self.same(wide[:, 2:5], twice[::2], np.stack([self.drawn] * 3, 1)[:, 1])
        self.same(np.asfortranarray(self.vertices), np.asfortranarray(self.faces))
        self.same(self.vertices[::-1][::-1], self.faces[::-1][::-1], self.drawn[::-1][::-1])
        self.same(self.vertices.tolist(), self.faces.tolist(), self.drawn.tolist())
        self.same(np.ma.array(self.vertices), self.faces, self.drawn.reshape(-1, 1)[:, 0])
        records = np.zeros(len(self.vertices), [("flag", "u1"), ("xyz", "<f8", 3)])
        records["xyz"] = self.vertices  # rows 25 bytes apart, at odd addresses
        self.same(records["xyz"], self.faces)
        readonly = self.vertices.copy()
        readonly.setflags(write=False)
        self.same(readonly, self.faces)

    def test_no_copy_where_the_layout_allows(self):
        wide = np.zeros((100, 7), np.float32)
        for array in (self.vertices, self.vertices.astype(np.float32), wide[:, 2:5],
                      self.vertices[::3], self.vertices[:1], np.zeros((0, 3))):
            seen = _arrays.readable(array, 3, "It")
            self.assertEqual(seen.__array_interface__["data"], array.__array_interface__["data"])
            self.assertEqual(seen.strides, array.strides)
        for array in (self.faces, self.faces.astype(np.int32), self.faces.astype(np.uint64)[::2]):
            self.assertTrue(np.shares_memory(_arrays.readable(array, 3, "It"), array))
        mesh = talweg.Mesh(self.vertices, self.faces)
        self.assertTrue(np.shares_memory(mesh.vertices, self.vertices))
        self.assertTrue(np.shares_memory(mesh.faces, self.faces))

    def test_copies_where_it_does_not(self):
        for array in (self.vertices[::-1], np.asfortranarray(self.vertices),
                      np.broadcast_to(np.zeros(3), (5, 3)), self.vertices.astype(np.float16)):
            seen = _arrays.readable(array, 3, "It")
            self.assertTrue(np.array_equal(seen, array))
            self.assertGreaterEqual(seen.strides[0], 3 * seen.itemsize)

    def test_fields_given_and_taken(self):
        slack = np.linspace(0.1, 3, len(self.vertices))
        expected = talweg.smooth((self.vertices, self.faces), self.drawn, slack_field=slack)
        padded = np.stack([slack, slack], 1)[:, 0]
        result = talweg.smooth((self.vertices, self.faces), self.drawn, slack_field=padded,
                               point_fields=True, vertex_fields=True)
        np.testing.assert_array_equal(result.curve.positions, expected.curve.positions)
        self.assertFalse(np.array_equal(result.curve.positions, self.expected))
        self.assertEqual(set(result.curve.fields), {"deviation", "curvature"})
        for values in result.curve.fields.values():
            self.assertEqual(values.shape, (len(result.curve),))
        largest = result.curve.fields["deviation"].max()
        self.assertLess(0, largest)
        self.assertLessEqual(largest, result.report.deviation_to_drawn_max)  # the report also measures
                                                                             # between points
        self.assertAlmostEqual(result.curve.fields["curvature"].sum(),
                               result.report.curvature_after, places=9)
        distance = result.fields["distance"]
        self.assertEqual(distance.shape, (len(self.vertices),))
        self.assertEqual(np.abs(distance[self.drawn]).max(), 0)

    def test_results_lie_on_the_mesh(self):
        curve = talweg.smooth((self.vertices, self.faces), self.drawn).curve
        np.testing.assert_allclose(curve.barycentrics.sum(axis=1), 1, atol=1e-15)
        self.assertGreaterEqual(curve.barycentrics.min(), 0)
        placed = np.einsum("nk,nkx->nx", curve.barycentrics, self.vertices[self.faces[curve.faces]])
        np.testing.assert_allclose(placed, curve.positions, atol=1e-12)
        at = curve.vertices >= 0
        self.assertTrue(at[0] and at[-1] and not at.all())
        np.testing.assert_array_equal(curve.positions[at], self.vertices[curve.vertices[at]])
        self.assertAlmostEqual(
            curve.length, talweg.smooth((self.vertices, self.faces), self.drawn).report.length_after,
            places=9)


    def test_representations(self):
        self.assertEqual(repr(talweg.Curve([1, 2, 3], closed=True)),
                         "<talweg.Curve: closed, 3 points>")
        result = talweg.smooth((self.vertices, self.faces), self.drawn)
        self.assertEqual(repr(result), f"<talweg.Result: [<talweg.Curve: open, {len(result.curve)} "
                                       "points>], converged>")
        lines = str(result.report).splitlines()
        self.assertIn("tau: 1.0", lines)
        self.assertNotIn("None", str(result.report))


class Stages(unittest.TestCase):
    def test_a_moved_tau_costs_only_its_stage(self):
        """Earlier stages are not repeated: their times stay the same."""
        work = talweg.Mesh(*support.hills(100)).workspace(support.staircase(100))
        first = work.smooth(1.0).report
        for tau in (0.5, 2.0, 1.0):
            report = work.smooth(tau).report
            self.assertEqual(report.time_ms["open"], first.time_ms["open"])
            self.assertEqual(report.time_ms["solve"], first.time_ms["solve"])
        stages = {p.id: p.stage for p in work.plugin.parameters.values()}
        self.assertEqual((stages["tau"], stages["slack"], stages["potential"]), (3, 3, 2))
        self.assertNotEqual(work.smooth(potential="paper").report.time_ms["solve"],
                            first.time_ms["solve"])

    def test_any_order_of_taus_gives_what_a_fresh_workspace_gives(self):
        mesh, drawn = talweg.Mesh(*support.hills()), support.staircase()
        work = mesh.workspace(drawn)
        for tau in (3.0, 0.0, 1.0, 3.0):
            np.testing.assert_array_equal(work.smooth(tau).curve.positions,
                                          mesh.smooth(drawn, tau).curve.positions)

    def test_parameters_and_their_defaults(self):
        work = talweg.Mesh(*support.hills()).workspace(support.staircase())
        self.assertEqual(work.parameters["tau"], 1.0)
        self.assertIsNone(work.parameters["slack"])
        before = work.run()
        work.set(slack=0.1, tau=4)
        self.assertEqual(work.run().report.slack, 0.1)
        work.set(slack=None, tau=None)
        after = work.run()
        self.assertEqual(after.report.slack, before.report.slack)
        np.testing.assert_array_equal(after.curve.positions, before.curve.positions)


if __name__ == "__main__":
    unittest.main()
