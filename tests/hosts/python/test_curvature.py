"""Turns along curves: the library's numbers, and their plot."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg
from talweg import _turning


def bending(turns, edge):
    """Bending as defined in docs/driver.md: edge times the integral of (T / w)^2, where w is half an edge."""
    window = edge / 2
    at, angle = turns.at, turns.angle
    if turns.closed:
        at = np.concatenate([at - turns.length, at, at + turns.length])
        angle = np.tile(angle, 3)
    places = np.unique(np.concatenate([at - window / 2, at + window / 2]))
    if turns.closed:
        places = np.unique(np.clip(places, 0, turns.length))
    middle = 0.5 * (places[1:] + places[:-1])
    sums = [angle[np.abs(at - place) < window / 2].sum() for place in middle]
    return edge * np.sum(np.diff(places) * (np.array(sums) / window) ** 2)


def fan(angles, boundary):
    """A vertex 0 with faces of these angles around it, and points at angles from the first edge."""
    ends = np.cumsum([0, *angles])
    scale = 1.0
    if not boundary:  # a cone over a circle: sides of length 1 with the given angles
        radius = None
        low, high = 0.0, 1.0
        for _ in range(200):
            radius = 0.5 * (low + high)
            chords = 2 * np.sin(np.array(angles) / 2)
            around = 2 * np.arcsin(np.clip(chords / (2 * radius), 0, 1)).sum()
            low, high = (radius, high) if around > 2 * np.pi else (low, radius)
        turns = np.cumsum([0, *(2 * np.arcsin(np.clip(chords / (2 * radius), 0, 1)))])[:-1]
        rim = np.stack([radius * np.cos(turns), radius * np.sin(turns),
                        np.full(len(turns), -np.sqrt(1 - radius**2))], 1)
    else:
        rim = np.stack([scale * np.cos(ends), scale * np.sin(ends), np.zeros(len(ends))], 1)
    n = len(rim)
    faces = [[0, 1 + k, 1 + (k + 1) % n] for k in range(len(angles))]
    return np.vstack([[[0, 0, 0]], rim]), np.array(faces)


class Turns(unittest.TestCase):
    def test_the_reports_numbers(self):
        """Numbers of results, through faces, edges and vertices, and of drawings along edges."""
        for (vertices, faces), drawn, closed in ((support.hills(), support.staircase(), False),
                                                 (support.torus(), support.ring(), True)):
            result = talweg.smooth((vertices, faces), drawn, closed=closed, point_fields=True)
            report, edge = result.report, result.report.edge_length_near
            after = _turning.turns_of(result.curve, vertices, faces)
            before = _turning.turns_of(result.drawn[0], vertices, faces)
            self.assertEqual((after.closed, before.closed), (closed, closed))
            self.assertAlmostEqual(after.length, report.length_after, delta=1e-12 * after.length)
            self.assertAlmostEqual(before.length, report.length_before, delta=1e-12 * before.length)
            self.assertAlmostEqual(bending(after, edge), report.bending_after,
                                   delta=1e-9 * report.bending_after)
            self.assertAlmostEqual(bending(before, edge), report.bending_before,
                                   delta=1e-9 * report.bending_before)
            ends = result.curve.positions[[0, -1]]
            expected = np.inf if closed else report.length_after / np.linalg.norm(ends[1] - ends[0])
            self.assertAlmostEqual(report.tortuosity_after, expected, places=12)
            self.assertEqual(talweg.measure((vertices, faces), result.curve).total["tortuosity"],
                             None if closed else report.tortuosity_after)
            inner = slice(None) if closed else slice(1, -1)
            free = result.curve.vertices[inner] < 0
            self.assertGreater(free.sum(), 50)
            np.testing.assert_allclose(np.abs(after.angle[free]),
                                       result.curve.fields["curvature"][inner][free], atol=1e-9)

    def test_plane(self):
        """In a plane the turns are those of the polyline, positive to the left."""
        vertices, faces = support.hills(12)
        vertices[:, 2] = 0
        path = np.array([13, 25, 26, 27, 39, 52, 64])
        turns = _turning.turns_of(talweg.Curve(path), vertices, faces)
        steps = np.diff(vertices[path][:, :2], axis=0)
        u, v = steps[:-1], steps[1:]
        expected = np.arctan2(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0], (u * v).sum(axis=1))
        np.testing.assert_allclose(turns.angle, expected, atol=1e-12)
        self.assertGreater(turns.angle.max(), 0.5)
        back = _turning.turns_of(talweg.Curve(path[::-1].copy()), vertices, faces)
        np.testing.assert_allclose(back.angle, -turns.angle[::-1], atol=1e-12)

    def test_vertices(self):
        """Half the difference of the side angles; on the boundary, pi minus the angle inside."""
        angles = [0.9, 0.7, 1.1, 0.8, 1.0]
        vertices, faces = fan(angles, boundary=False)
        for first, last in ((0, 2), (1, 3), (3, 0), (4, 1)):
            to_left = sum(angles[(last + k) % 5] for k in range((first - last) % 5))
            turns = _turning.turns_of(talweg.Curve([1 + first, 0, 1 + last]), vertices, faces)
            self.assertAlmostEqual(turns.angle[0], 0.5 * sum(angles) - to_left, places=9)
        vertices, faces = fan(angles[:3], boundary=True)
        for first, last, expected in ((0, 2, 1.6 - np.pi), (2, 0, np.pi - 1.6), (0, 3, 2.7 - np.pi)):
            turns = _turning.turns_of(talweg.Curve([1 + first, 0, 1 + last]), vertices, faces)
            self.assertAlmostEqual(turns.angle[0], expected, places=9)

    def test_windows(self):
        """A circle in a plane turns by 1 / radius everywhere, and all windows together by 2 pi."""
        count, radius = 400, 5.0
        at = np.arange(count) * 2 * np.pi * radius / count
        turns = _turning.Turns(at, np.full(count, 2 * np.pi / count), 2 * np.pi * radius, True)
        for window in (3.0, 100.0):
            steps, values = turns.curvature_along(window)
            self.assertEqual((steps[0], steps[-1]), (0, turns.length))
            np.testing.assert_allclose(values, 1 / radius, rtol=0.03)
            self.assertAlmostEqual(np.sum(values * np.diff(steps)), 2 * np.pi, places=9)
        one = _turning.Turns(np.array([4.0]), np.array([0.5]), 10.0, False)
        steps, values = one.curvature_along(2.0)
        np.testing.assert_allclose(steps, [0, 3, 5, 10])
        np.testing.assert_allclose(values, [0, 0.25, 0])


class Plots(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        cls.mesh = talweg.Mesh(cls.vertices, cls.faces)
        cls.result = cls.mesh.smooth(support.staircase())

    def setUp(self):
        try:
            from matplotlib.figure import Figure  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("no matplotlib (Debian: python3-matplotlib)")
        self.axes = Figure().add_subplot()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def labels(self):
        return [text.get_text() for text in self.axes.get_legend().get_texts()]

    def test_axes(self):
        self.assertIs(talweg.plot_curvature(self.result, self.axes, unit="mm"), self.axes)
        self.assertEqual(self.axes.get_xlabel(), "along the curve (mm)")
        self.assertEqual(self.axes.get_ylabel(), "curvature (rad / mm)")
        self.assertEqual(self.labels(), ["result", "drawn"])
        steps = {patch.get_label(): patch.get_data() for patch in self.axes.patches}
        for data in steps.values():  # both over the whole length of the result
            self.assertEqual(data.edges[0], 0)
            self.assertAlmostEqual(data.edges[-1], self.result.report.length_after, places=9)
        self.assertGreater(np.abs(steps["drawn"].values).max(),
                           3 * np.abs(steps["result"].values).max())
        self.assertGreater(self.axes.get_ylim()[1], np.abs(steps["result"].values).max())
        self.assertLess(self.axes.get_ylim()[1], np.abs(steps["drawn"].values).max())

    def test_files(self):
        talweg.plot_curvature(self.result, file=self.folder / "a.png")
        self.assertEqual((self.folder / "a.png").read_bytes()[:4], b"\x89PNG")
        with self.assertRaisesRegex(talweg.BadFile, "nowhere"):
            talweg.plot_curvature(self.result, file=self.folder / "nowhere/a.png")

    def test_drawings_of_every_kind(self):
        """Drawings as positions near the surface, as a result, as several curves, and as a loop."""
        positions = self.vertices[support.staircase()] + [0, 0, 0.05]
        for drawn in (positions, self.result.curve):
            talweg.plot_curvature(self.mesh.smooth(drawn), self.axes)
            self.assertEqual(self.labels(), ["result", "drawn"])
            self.axes.clear()
        two = [talweg.Curve(support.staircase()), talweg.draw((self.vertices, self.faces), [305, 355])]
        talweg.plot_curvature(self.mesh.smooth(two), self.axes)
        self.assertEqual(self.labels(), ["result 1", "drawn", "result 2"])
        self.axes.clear()
        vertices, faces = support.torus()
        talweg.plot_curvature(talweg.smooth((vertices, faces), support.ring(), closed=True), self.axes)

    def test_straight_lines_do_not_turn(self):
        flat = self.vertices * [1, 1, 0]
        talweg.plot_curvature(talweg.geodesic((flat, self.faces), support.staircase()), self.axes)
        steps = {patch.get_label(): patch.get_data() for patch in self.axes.patches}
        self.assertLess(np.abs(steps["result"].values).max(), 1e-6)

    def test_refused(self):
        for window in (0, -1, np.nan, "a", np.inf):
            with self.assertRaisesRegex(talweg.BadUsage, "window must be a length"):
                talweg.plot_curvature(self.result, self.axes, window=window)
        with self.assertRaisesRegex(talweg.BadUsage, "no curves"):
            talweg.plot_curvature(talweg.Result([], [], talweg.Report()), self.axes)


if __name__ == "__main__":
    unittest.main()
