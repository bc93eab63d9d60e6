"""Talweg Cut and Talweg Measure: pieces with all arrays, chains, the table, wrong input."""

import math
import unittest

from vtkmodules.vtkCommonCore import (vtkDoubleArray, vtkFloatArray, vtkIntArray, vtkStringArray,
                                      vtkUnsignedCharArray)
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import runner
from support import (Case, cell_values, counts, lines_of, output, places, polydata, pv, report, source,
                     told, values)

SIDE = 8
# A flat sheet, triangles of squares of side 1, and a straight line through it between vertices.
POINTS = [(float(x), float(y), 0.0) for y in range(SIDE + 1) for x in range(SIDE + 1)]
N = SIDE + 1
TRIANGLES = [t for y in range(SIDE) for x in range(SIDE)
             for a in [N * y + x] for t in [(a, a + 1, a + N + 1), (a, a + N + 1, a + N)]]
LINE = [(0.0, 3.5, 0.0), (4.5, 3.5, 0.0), (8.0, 3.5, 0.0)]
LOOP = [(2.25, 2.25, 0.0), (5.75, 2.25, 0.0), (5.75, 5.75, 0.0), (2.25, 5.75, 0.0),
        (2.25, 2.25, 0.0)]


def filled(kind, name, rows, components=1):
    array = kind()
    array.SetName(name)
    array.SetNumberOfComponents(components)
    for row in rows:
        if components > 1:
            array.InsertNextTuple(row)
        else:
            array.InsertNextValue(row)
    return array


def sheet():
    """A sheet with all common kinds of ParaView's arrays."""
    data = polydata(POINTS, TRIANGLES)
    at_points, at_cells = data.GetPointData(), data.GetCellData()
    at_points.AddArray(filled(vtkDoubleArray, "plane", [x + 10 * y for x, y, _ in POINTS]))
    at_points.AddArray(filled(vtkIntArray, "row", [int(y) for _, y, _ in POINTS]))
    at_points.AddArray(filled(vtkFloatArray, "my_label", [y for _, y, _ in POINTS]))
    at_points.AddArray(filled(vtkStringArray, "text", [f"row {int(y)}" for _, y, _ in POINTS]))
    at_points.AddArray(filled(vtkUnsignedCharArray, "colour",
                              [(int(20 * y), 0, 255) for _, y, _ in POINTS], 3))
    at_points.SetNormals(filled(vtkFloatArray, "Normals",
                                [(math.sin(y), 0, math.cos(y)) for _, y, _ in POINTS], 3))
    at_cells.AddArray(filled(vtkStringArray, "cell_text", map(str, range(len(TRIANGLES)))))
    at_cells.SetScalars(filled(vtkIntArray, "number", range(len(TRIANGLES))))
    return data


def curves(*lines):
    points = [p for line in lines for p in line]
    numbers = iter(range(len(points)))
    return source(polydata(points, lines=[[next(numbers) for _ in line] for line in lines]))


def cut(*lines, **properties):
    return pv.TalwegCut(Mesh=source(sheet()), Curve=curves(*lines), **properties)


def area(data):
    total = 0
    for k in range(data.GetNumberOfCells()):
        (ax, ay, _), (bx, by, _), (cx, cy, _) = (
            data.GetPoint(data.GetCell(k).GetPointId(i)) for i in range(3))
        total += ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
    return total


class Pieces(Case):
    def pieces(self, filter):
        self.update(filter)
        data = output(filter, 0)
        self.assertEqual(data.GetClassName(), "vtkMultiBlockDataSet")
        return [data.GetBlock(k) for k in range(data.GetNumberOfBlocks())]

    def test_the_outcome_counts_pieces(self):
        filter = cut(LINE)
        self.pieces(filter)
        self.assertEqual(told(filter), "One piece.")
        filter.Split = 1
        self.pieces(filter)
        self.assertEqual(told(filter), "2 pieces.")

    def test_one_mesh_with_the_curve_as_edges(self):
        (whole,) = self.pieces(cut(LINE))
        self.assertAlmostEqual(area(whole), SIDE * SIDE, 12)
        self.assertGreater(whole.GetNumberOfCells(), len(TRIANGLES))
        self.assertEqual(places(whole)[:len(POINTS)], POINTS)  # no vertex moves

    def test_pieces_have_their_areas(self):
        pieces = self.pieces(cut(LINE, Open=1, Split=1))
        self.assertEqual(sorted(round(area(piece), 12) for piece in pieces), [3.5 * 8, 4.5 * 8])
        (left,) = self.pieces(cut(LINE, Keep="left", Open=1))
        self.assertAlmostEqual(area(left), 4.5 * 8, 12)
        # The part outside the loop, on its right.
        (outside,) = self.pieces(cut(LOOP, Keep="right", Open=1))
        self.assertAlmostEqual(area(outside), 64 - 3.5 ** 2, 12)

    def test_arrays_of_points(self):
        for piece in self.pieces(cut(LINE, LOOP, Open=1, Split=1)):
            at = piece.GetPointData()
            for k, (x, y, _) in enumerate(places(piece)):
                self.assertAlmostEqual(at.GetArray("plane").GetValue(k), x + 10 * y, 12)
                row = at.GetArray("row").GetValue(k)
                self.assertLessEqual(abs(row - y), 1)
                self.assertEqual(at.GetArray("my_label").GetValue(k), row)
                self.assertEqual(at.GetAbstractArray("text").GetValue(k), f"row {row}")
                red, green, blue = at.GetArray("colour").GetTuple(k)
                self.assertLessEqual(abs(red - 20 * y), 0.5 + 1e-9)
                self.assertEqual((green, blue), (0, 255))
                self.assertAlmostEqual(math.hypot(*at.GetArray("Normals").GetTuple(k)), 1, 6)
            for name, kind in (("plane", "vtkDoubleArray"), ("row", "vtkIntArray"),
                               ("my_label", "vtkFloatArray"), ("colour", "vtkUnsignedCharArray")):
                self.assertEqual(at.GetArray(name).GetClassName(), kind)
            self.assertEqual(at.GetNormals().GetName(), "Normals")

    def test_arrays_of_cells(self):
        for piece in self.pieces(cut(LINE, Open=1, Split=1)):
            at = piece.GetCellData()
            self.assertEqual(at.GetScalars().GetName(), "number")
            for k, number in enumerate(cell_values(piece, "number")):
                self.assertEqual(at.GetAbstractArray("cell_text").GetValue(k), str(int(number)))
                self.assertEqual(at.GetArray("origin_cell").GetValue(k), number)
                corners = [POINTS[v] for v in TRIANGLES[int(number)]]
                for i in range(3):
                    x, y, _ = piece.GetPoint(piece.GetCell(k).GetPointId(i))
                    self.assertGreaterEqual(x, min(c[0] for c in corners) - 1e-12)
                    self.assertLessEqual(y, max(c[1] for c in corners) + 1e-12)

    def test_polygons_give_their_values_to_all_parts(self):
        squares = [(N * y + x, N * y + x + 1, N * y + x + N + 1, N * y + x + N)
                   for y in range(SIDE) for x in range(SIDE)]
        data = polydata(POINTS, squares)
        data.GetCellData().AddArray(filled(vtkIntArray, "square", range(len(squares))))
        filter = pv.TalwegCut(Mesh=source(data), Curve=curves(LINE))
        self.assertTrue(any("cut into triangles" in text for text in self.update(filter)))
        whole = output(filter, 0).GetBlock(0)
        for k, square in enumerate(cell_values(whole, "square")):
            x, y, _ = (sum(whole.GetPoint(whole.GetCell(k).GetPointId(i))[c] for i in range(3)) / 3
                       for c in range(3))
            self.assertEqual(square, SIDE * int(y) + int(x))

    def test_lids_have_no_values(self):
        mesh = pv.Sphere(ThetaResolution=24, PhiResolution=24)
        ring = [(0.5 * math.cos(a), 0.5 * math.sin(a), 0.12)
                for a in [math.tau * k / 40 for k in range(40)]]
        filter = pv.TalwegCut(Mesh=mesh, Curve=curves(ring + ring[:1]), Open=1, Split=1,
                              Cap="auto")
        for piece in self.pieces(filter):
            origins = cell_values(piece, "origin_cell")
            self.assertIn(-1, origins)
            self.assertLess(max(origins), 24 * 24 * 2)

    def test_each_mesh_of_a_composite_has_a_block_with_its_pieces(self):
        both = pv.GroupDatasets(Input=[source(sheet()), source(sheet())])
        filter = pv.TalwegCut(Mesh=both, Curve=curves(LINE), Open=1, Split=1)
        for pieces in self.pieces(filter):
            self.assertEqual(sorted(round(area(pieces.GetBlock(k)), 12) for k in range(2)),
                             [3.5 * 8, 4.5 * 8])
        self.assertEqual(output(filter, 0).GetNumberOfBlocks(), 2)
        self.assertEqual(output(filter, 1).GetNumberOfLines(), 2)
        again = pv.TalwegCut(Mesh=cut(LINE, Open=1, Split=1), Curve=curves(LOOP))
        areas = [area(block.GetBlock(0)) for block in self.pieces(again)]
        self.assertAlmostEqual(sum(areas), SIDE * SIDE, 12)

    def test_chains_are_the_curves(self):
        filter = cut(LINE, LOOP)
        self.update(filter)
        chains = output(filter, 1)
        self.assertEqual(cell_values(chains, "curve"), [0, 1])
        straight, loop = lines_of(chains)
        for k in straight:
            self.assertAlmostEqual(chains.GetPoint(k)[1], 3.5, 12)
        self.assertEqual(loop[0], loop[-1])
        self.assertNotEqual(straight[0], straight[-1])
        (whole,) = self.pieces(filter)
        self.assertLessEqual(set(places(chains)), set(places(whole)))

    def test_a_stretch_of_a_loop_is_one_line(self):
        # The loops start inside each other, and only the part inside both is kept.
        other = [(4.25, 4.25, 0.0), (1.25, 4.25, 0.0), (1.25, 1.25, 0.0), (4.25, 1.25, 0.0),
                 (4.25, 4.25, 0.0)]
        filter = cut(LOOP, other, Keep="left", Open=1)
        self.update(filter)
        chains = output(filter, 1)
        self.assertEqual(cell_values(chains, "curve"), [0, 1])
        for line, start in zip(lines_of(chains), (LOOP[0], other[0])):
            ends = [chains.GetPoint(k) for k in (line[0], line[-1])]
            self.assertNotEqual(*ends)
            self.assertNotIn(start, ends)
            self.assertIn(start, [chains.GetPoint(k) for k in line])

    def test_the_report_is_in_the_field_data(self):
        filter = cut(LINE, Open=1, Split=1)
        self.update(filter)
        data = output(filter, 0)
        self.assertEqual(report(data, "pieces"), 2)
        self.assertEqual(sum(report(data, "parts.faces")),
                         sum(data.GetBlock(k).GetNumberOfCells() for k in range(2)))


class Changes(Case):
    def test_the_mesh_is_opened_once_and_repair_opens_it_again(self):
        filter = cut(LINE)
        self.update(filter)
        filter.Open = 1
        self.update(filter)
        self.assertEqual(output(filter, 0).GetNumberOfBlocks(), 1)
        first = places(output(filter, 0).GetBlock(0))
        filter.Repair = 1
        self.update(filter)
        self.assertEqual(places(output(filter, 0).GetBlock(0)), first)


class Warnings(Case):
    def test_a_curve_far_from_the_mesh(self):
        above = [(x, y, 6.0) for x, y, _ in LINE]
        for make in (pv.TalwegCut, pv.TalwegMeasure):
            filter = make(Mesh=source(sheet()), Curve=curves(above))
            self.assertIn("The drawing lies far from the mesh", "".join(self.update(filter)))
            filter.Repair = 1
            self.update(filter)


class CurvesInBlocks(Case):
    """Lines of a composite data set are curves as in a single data set."""

    def blocks(self, *lines):
        data = vtkMultiBlockDataSet()
        for k, line in enumerate(lines):
            data.SetBlock(k, polydata(line, lines=[range(len(line))]))
        return source(data)

    def test_cut(self):
        filter = pv.TalwegCut(Mesh=source(sheet()), Curve=self.blocks(LINE, LOOP), Split=1, Open=1)
        self.update(filter)
        together = cut(LINE, LOOP, Split=1, Open=1)
        self.update(together)
        pieces = [output(f, 0) for f in (filter, together)]
        self.assertEqual([p.GetNumberOfBlocks() for p in pieces], [4, 4])
        for k in range(4):
            self.assertEqual(*[places(p.GetBlock(k)) for p in pieces])
        self.assertEqual(cell_values(output(filter, 1), "curve"),
                         cell_values(output(together, 1), "curve"))

    def test_measure_and_smooth(self):
        mesh = source(sheet())
        table = pv.TalwegMeasure(Mesh=mesh, Curve=self.blocks(LINE, LOOP), Others=self.blocks(LOOP))
        self.update(table)
        self.assertEqual(output(table, 0).GetNumberOfRows(), 3)
        self.assertAlmostEqual(output(table, 0).GetValueByName(2, "length").ToDouble(), 22, 12)
        smooth = pv.TalwegSmoothCurve(Mesh=mesh, Curve=self.blocks(LINE, LOOP))
        self.update(smooth)
        self.assertEqual(len(lines_of(output(smooth, 0))), 2)
        smooth.Tau = 3
        self.update(smooth)
        self.assertEqual(counts(smooth), (1, 1, 2))

    def test_no_block(self):
        filter = pv.TalwegCut(Mesh=source(sheet()), Curve=self.blocks())
        self.assertIn("The input Curve has no points.", self.error_of(filter))


class WrongInput(Case):
    def test_without_a_curve_there_is_one_sentence(self):
        for make, sentence in ((pv.TalwegCut, "No curves are given: choose some"),
                               (pv.TalwegMeasure, "No curves are given: choose some"),
                               (pv.TalwegSmoothCurve, "No curve is given: choose one")):
            filter = make(Mesh=source(sheet()), Curve=None)
            self.assertIn(sentence, self.error_of(filter))
            # Such a domain would make the window print "Index out of range: 0" until there is a curve.
            names = filter.SMProxy.GetProperty("CurveIds")
            self.assertIsNone(names.FindDomain("vtkSMArrayListDomain"))

    def test_sentences(self):
        self.assertIn("no points", self.error_of(pv.TalwegCut(Mesh=source(sheet()),
                                                              Curve=source(polydata([])))))
        self.assertIn("Merge must be", self.error_of(cut(LINE, Merge=-1)))
        self.assertIn("no faces", self.error_of(
            pv.TalwegCut(Mesh=source(polydata([(0, 0, 0)])), Curve=curves(LINE))))
        far = [(1e5, 0, 0), (1e5, 1, 0)]
        self.assertIn("another unit or place", self.error_of(cut(far)))

    def test_a_mesh_that_is_no_surface_is_refused_and_cut_when_repaired(self):
        three = [(0, 1, 2), (1, 0, 3), (0, 1, 4)]
        mesh = source(polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], three))
        filter = pv.TalwegCut(Mesh=mesh, Curve=curves([(0.1, 0.2, 0), (0.3, 0.2, 0)]))
        self.assertIn("edge", self.error_of(filter))
        filter.Repair = 1
        self.update(filter)
        whole = output(filter, 0).GetBlock(0)
        self.assertLessEqual({0, 1, 2}, set(cell_values(whole, "origin_cell")))
        filter.Repair = 0
        self.assertIn("edge", self.error_of(filter))


class Measure(Case):
    def table(self, filter):
        self.update(filter)
        data = output(filter, 0)
        self.assertEqual(data.GetClassName(), "vtkTable")
        names = [data.GetColumnName(k) for k in range(data.GetNumberOfColumns())]
        return [{name: data.GetValueByName(row, name) for name in names}
                for row in range(data.GetNumberOfRows())]

    def test_a_row_for_each_curve_and_one_for_all(self):
        rows = self.table(pv.TalwegMeasure(Mesh=source(sheet()), Curve=curves(LINE, LOOP)))
        self.assertEqual([row["# curve"].ToString() for row in rows], ["0", "1", "all"])
        for row, length in zip(rows, (8, 14, 22)):
            self.assertAlmostEqual(row["length"].ToDouble(), length, 12)
        self.assertAlmostEqual(rows[1]["curvature"].ToDouble(), math.tau, 9)
        self.assertEqual([row["closed"].ToDouble() for row in rows[:2]], [0, 1])

    def test_the_column_that_a_spreadsheet_shows_first_says_which_curve(self):
        filter = pv.TalwegMeasure(Mesh=source(sheet()), Curve=curves(LINE, LOOP))
        rows = self.table(filter)
        self.assertEqual(min(rows[0], key=str.lower), "# curve")  # sorted first with any treatment of case
        # Entries that are not measures of curves are in the field data, and every cell has a number.
        for row in rows:
            self.assertNotIn("faces", row)
            for name, value in row.items():
                if name != "# curve" and value.IsNumeric():
                    self.assertFalse(math.isnan(value.ToDouble()), name)
        data = output(filter, 0)
        self.assertEqual(report(data, "faces"), sheet().GetNumberOfPolys())

    def test_the_outcome_tells_the_length(self):
        filter = pv.TalwegMeasure(Mesh=source(sheet()), Curve=curves(LINE))
        self.update(filter)
        self.assertEqual(told(filter), "1 curve, length 8. The rest is in the table.")

    def test_others_are_compared_with(self):
        shifted = [(x, y + 0.25, z) for x, y, z in LINE]
        rows = self.table(pv.TalwegMeasure(Mesh=source(sheet()), Curve=curves(LINE),
                                           Others=curves(shifted)))
        self.assertAlmostEqual(rows[-1]["deviation_to_other_max"].ToDouble(), 0.25, 9)
        self.assertEqual(len(rows), 2)

    def test_sentences(self):
        filter = pv.TalwegMeasure(Mesh=source(sheet()), Curve=curves(LINE), Edge=0)
        self.assertIn("Edge must be", self.error_of(filter))


if __name__ == "__main__":
    runner.main()
