"""Talweg Offset: on a plane, where offsets of a straight line are known."""

import math
import unittest

import runner
from support import (Case, cell_values, column, counts, lines_of, output, places, polydata, pv, report,
                     source, told, values)

N = 41  # vertices of a side, a unit apart

POINTS = [(float(x), float(y), 0.0) for y in range(N) for x in range(N)]
TRIANGLES = [t for y in range(N - 1) for x in range(N - 1) for a in [N * y + x]
             for t in ((a, a + 1, a + N + 1), (a, a + N + 1, a + N))]
LINE = [(10.0, 20.0, 0.0), (30.0, 20.0, 0.0)]


def plane():
    return source(polydata(POINTS, TRIANGLES))


def line(points=LINE):
    return source(polydata(points, lines=[range(len(points))]))


def length_of(data, cell):
    at = [data.GetPoint(k) for k in cell]
    return sum(math.dist(a, b) for a, b in zip(at, at[1:]))


def area_of(data):
    return sum(data.GetCell(k).ComputeArea() for k in range(data.GetNumberOfCells()))


class Offset(Case):
    def test_around_a_line(self):
        filter = pv.TalwegOffset(Mesh=plane(), Curve=line(), Distance=3)
        curves = self.curve_of(filter)
        loop, = lines_of(curves)
        self.assertEqual(loop[0], loop[-1])
        self.assertAlmostEqual(length_of(curves, loop), 2 * 20 + 6 * math.pi, delta=0.02)
        for x, y, _ in places(curves):
            self.assertAlmostEqual(math.hypot(x - min(max(x, 10), 30), y - 20), 3, 8)
        self.assertEqual(cell_values(curves, "distance"), [3])
        self.assertEqual(curves.GetCellData().GetAbstractArray("side").GetValue(0), "both")
        self.assertRegex(told(filter), r"^1 curve, length 58\.8\d*\. Off by at most ")

    def test_one_side_at_several_distances(self):
        filter = pv.TalwegOffset(Mesh=plane(), Curve=line(), Distance=2, Count=3, Side="left")
        curves = self.curve_of(filter)
        self.assertEqual(cell_values(curves, "distance"), [2, 4, 6])
        self.assertEqual(cell_values(curves, "along"), [0, 0, 0])
        for cell, y in zip(lines_of(curves), (22, 24, 26)):  # seen from above along +x
            self.assertAlmostEqual(length_of(curves, cell), 20, 8)
            for k in cell:
                self.assertAlmostEqual(curves.GetPoint(k)[1], y, 8)
        table = output(filter, 1)
        self.assertEqual(column(table, "# curve"), ["0", "1", "2", "all"])
        self.assertEqual(column(table, "distance")[:3], [2, 4, 6])
        self.assertAlmostEqual(column(table, "length")[3], 60, 8)
        self.assertEqual(report(curves, "components"), 3)
        self.assertEqual(len(values(curves, "arc_length")), curves.GetNumberOfPoints())

    def test_a_new_distance_opens_no_mesh_again(self):
        filter = pv.TalwegOffset(Mesh=plane(), Curve=line(), Distance=3)
        self.curve_of(filter)
        filter.Distance = 4
        self.assertEqual(cell_values(self.curve_of(filter), "distance"), [4])
        self.assertEqual(counts(filter), (1, 1, 2))

    def test_the_band_is_a_piece(self):
        offset = pv.TalwegOffset(Mesh=plane(), Curve=line(), Distance=3)
        cut = pv.TalwegCut(Mesh=plane(), Curve=pv.OutputPort(offset, 0), Split=1)
        self.update(cut)
        pieces = output(cut, 0)
        areas = sorted(area_of(pieces.GetBlock(k)) for k in range(pieces.GetNumberOfBlocks()))
        self.assertEqual(len(areas), 2)
        self.assertAlmostEqual(areas[0], 20 * 6 + 9 * math.pi, delta=0.05)
        self.assertAlmostEqual(sum(areas), (N - 1) ** 2, 6)

    def test_sentences(self):
        far = pv.TalwegOffset(Mesh=plane(), Curve=line(), Distance=100)
        self.assertIn("farthest", self.error_of(far))
        none = pv.TalwegOffset(Mesh=plane())
        self.assertIn("No curves are given", self.error_of(none))
        partly = pv.TalwegOffset(Mesh=plane(), Curve=line(), Distance=20, Count=3)
        self.assertTrue(any("60" in sentence for sentence in self.update(partly)))
        self.assertIn("Note: ", told(partly))


if __name__ == "__main__":
    runner.main()
