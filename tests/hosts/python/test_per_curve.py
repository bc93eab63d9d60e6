"""Curves of one set with different values of tau, slack and finish."""

import unittest

import numpy as np

import support
import talweg


class PerCurve(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        vertices, faces = support.hills()
        cls.mesh = talweg.Mesh(vertices, faces)
        draw = talweg.Mesh(vertices, faces, plugin="talweg.draw").draw
        cls.curves = [draw([r * 60 + 4, (r + 3) * 60 + 30, r * 60 + 55], exact=False)
                      for r in (8, 28, 48)]

    def equal(self, ours, theirs):
        np.testing.assert_array_equal(ours.faces, theirs.faces)
        np.testing.assert_array_equal(ours.barycentrics, theirs.barycentrics)

    def test_a_list_has_a_value_for_each(self):
        own = self.mesh.smooth(self.curves, [0.4, 3, 0.05], slack=[None, 0.5, None],
                               finish=["taut", "fair", None])
        common = ({"tau": 0.4, "finish": "taut"}, {"tau": 3, "slack": 0.5}, {"tau": 0.05})
        for k, parameters in enumerate(common):
            self.equal(own.curves[k], self.mesh.smooth(self.curves, **parameters).curves[k])
        self.assertEqual([r.tau for r in own.reports], [0.4, 3, 0.05])
        self.equal(self.mesh.smooth(self.curves, np.array([0.4, 3, 0.05])).curves[1],
                   self.mesh.smooth(self.curves, 3).curves[1])

    def test_one_value_takes_the_list_back(self):
        work = self.mesh.workspace(self.curves)
        work.smooth([1, 2, 3])
        self.assertEqual(work.parameters["taus"], [1, 2, 3])
        for ours, theirs in zip(work.smooth(2).curves, self.mesh.smooth(self.curves, 2).curves):
            self.equal(ours, theirs)
        self.assertIsNone(work.parameters["taus"])

    def test_one_value_beside_the_list_is_for_the_rest(self):
        work = self.mesh.workspace(self.curves)
        expected = self.mesh.smooth(self.curves, [0.1, 3, 0.5]).curves
        for _ in range(2):  # the second time the list already exists
            result = work.smooth(3, taus=[0.1, -1, 0.5])
            self.assertEqual(work.parameters["taus"], [0.1, -1, 0.5])
            for ours, theirs in zip(result.curves, expected):
                self.equal(ours, theirs)

    def test_bad_values(self):
        for values, words in (([1, 2], "2 values for 3 curves"), ([1, -3, 1], "curve 1, not -3"),
                              ([1, "much", 1], "'much'")):
            with self.assertRaisesRegex(talweg.BadUsage, words):
                self.mesh.smooth(self.curves, values)
        with self.assertRaisesRegex(talweg.BadUsage, "fair, taut, not of 'loose'"):
            self.mesh.smooth(self.curves, finish=["fair", "loose", "fair"])

    def test_a_corner_is_passed_and_may_turn(self):
        corner = int(self.curves[0].vertices[len(self.curves[0].vertices) // 2])
        result = self.mesh.smooth(self.curves[0], corner=[corner]).curve
        self.assertIn(corner, result.vertices.tolist())
        with self.assertRaisesRegex(talweg.BadUsage, "corner at vertex 0"):
            self.mesh.smooth(self.curves[0], corner=[0])


if __name__ == "__main__":
    unittest.main()
