"""Talweg Label Borders: borders, new labels and the exact cut, from cell and from point arrays."""

import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray, vtkUnsignedCharArray

import runner
from support import (Case, cell_values, column, lines_of, output, places, polydata, pv, real_mesh, report,
                     source, told, values, wavy_sheet)

N = 24
POINTS, TRIANGLES = wavy_sheet(N)


def left_of(x, y):
    """A border that alternates from row to row."""
    return x < 0.5 + (0.03 if int(round(y * (N - 1))) % 2 else -0.03)


def centre(data, cell):
    return [sum(data.GetPoint(data.GetCell(cell).GetPointId(i))[k] for i in range(3)) / 3
            for k in range(3)]


def labelled(of_cells, kind=vtkUnsignedCharArray):
    data = polydata(POINTS, TRIANGLES)
    array = kind()
    array.SetName("tissue")
    if of_cells:
        for k in range(len(TRIANGLES)):
            x, y, _ = centre(data, k)
            array.InsertNextValue(3 if left_of(x, y) else 7)
        data.GetCellData().AddArray(array)
    else:
        for x, y, _ in POINTS:
            array.InsertNextValue(3 if left_of(x, y) else 7)
        data.GetPointData().AddArray(array)
    return source(data)


def striped(of_cells_too=False):
    """Four stripes: three borders."""
    data = polydata(POINTS, TRIANGLES)
    for name, places, out in (("stripe", POINTS, data.GetPointData()),
                              *([("row", range(len(TRIANGLES)), data.GetCellData())] * of_cells_too)):
        array = vtkUnsignedCharArray()
        array.SetName(name)
        for place in places:
            array.InsertNextValue(int(3.99 * place[0]) if name == "stripe" else place % 2)
        out.AddArray(array)
    return source(data)


class Labels(Case):
    def check(self, filter, of_cells):
        self.update(filter)
        borders, mesh, cut = (output(filter, port) for port in range(3))
        self.assertEqual(len(lines_of(borders)), 1)
        self.assertEqual(sorted((cell_values(borders, "left")[0], cell_values(borders, "right")[0])),
                         [3, 7])
        self.assertLess(report(borders, "curvature_after"), 0.5 * report(borders, "curvature_before"))
        self.assertEqual(report(borders, "regions.label"), [3, 7])
        kept = mesh.GetCellData() if of_cells else mesh.GetPointData()
        self.assertEqual(kept.GetArray("tissue").GetNumberOfTuples(),
                         len(TRIANGLES) if of_cells else len(POINTS))
        self.assertEqual(places(mesh), POINTS)
        for data in (mesh, cut):
            labels = cell_values(data, "new_label")
            self.assertEqual(set(labels), {3, 7})
            self.assertEqual(data.GetCellData().GetArray("new_label").GetClassName(),
                             "vtkUnsignedCharArray")
            for k, label in enumerate(labels):
                x = centre(data, k)[0]
                if abs(x - 0.5) > 0.15:
                    self.assertEqual(label, 3 if x < 0.5 else 7)
        # The borders are edges of the cut mesh: its labels change there and nowhere else.
        sides = {}
        for k, label in enumerate(cell_values(cut, "new_label")):
            ids = [cut.GetCell(k).GetPointId(i) for i in range(3)]
            for a, b in zip(ids, ids[1:] + ids[:1]):
                sides.setdefault(frozenset((a, b)), set()).add(label)
        between = {v for edge, labels in sides.items() if len(labels) == 2 for v in edge}
        on_border = set(places(borders))
        self.assertGreater(len(between), 10)
        near = sum(cut.GetPoint(v) in on_border for v in between)
        self.assertGreater(near, 0.5 * len(between))

    def test_cells(self):
        self.check(pv.TalwegLabelBorders(Mesh=labelled(True), TriangleLabels="tissue"), True)

    def test_points(self):
        self.check(pv.TalwegLabelBorders(Mesh=labelled(False), VertexLabels="tissue"), False)

    def test_reports_are_a_table(self):
        filter = pv.TalwegLabelBorders(Mesh=striped())
        filter.VertexLabels = "stripe"
        self.update(filter)
        borders, table = output(filter, 0), output(filter, 3)
        count = len(lines_of(borders))
        self.assertEqual(count, 3)
        self.assertEqual(column(table, "# curve"), ["0", "1", "2", "all"])
        for side in ("left", "right"):
            self.assertEqual(column(table, side)[:-1], cell_values(borders, side))
        lengths = column(table, "length_after")
        self.assertAlmostEqual(lengths[-1], sum(lengths[:-1]), 9)
        self.assertEqual(report(table, "regions.label"), [0, 1, 2, 3])
        cells = borders.GetCellData()
        self.assertEqual({cells.GetArrayName(k) for k in range(cells.GetNumberOfArrays())},
                         {"curve", "left", "right"})  # the rest is in the table

    def test_the_outcome_tells_what_was_reached(self):
        filter = pv.TalwegLabelBorders(Mesh=striped(), VertexLabels="stripe")
        self.update(filter)
        reached = max(report(output(filter, 0), f"deviation_{way}_drawn_max") for way in ("to", "from"))
        self.assertRegex(told(filter), "^3 borders between 4 regions, 0 junctions. Deviation from the drawing")
        self.assertIn(f"at most {reached:.4g},", told(filter))
        filter = pv.TalwegLabelBorders(Mesh=labelled(True), TriangleLabels="tissue")
        self.update(filter)
        self.assertIn("1 border between 2 regions, 0 junctions. ", told(filter))

    def test_a_new_tau_opens_no_mesh_again_and_changed_labels_are_used(self):
        calculator = pv.Calculator(Input=source(polydata(POINTS, TRIANGLES)),
                                   Function="floor(coordsX*1.9)", ResultArrayName="half")
        filter = pv.TalwegLabelBorders(Mesh=calculator, VertexLabels="half")
        self.update(filter)
        first = places(output(filter, 0))
        filter.Tau = 8
        self.update(filter)
        filter.Tau = 1
        self.update(filter)
        self.assertEqual(places(output(filter, 0)), first)
        filter.SMProxy.UpdatePropertyInformation()
        self.assertEqual(filter.SMProxy.GetProperty("MeshesOpened").GetElement(0), 1)
        calculator.Function = "floor(coordsX*1.5)"
        self.update(filter)
        self.assertNotEqual(places(output(filter, 0)), first)

    def test_abort_gives_nothing_and_is_no_error(self):
        filter = pv.TalwegLabelBorders(Mesh=labelled(True), TriangleLabels="tissue")
        algorithm = filter.GetClientSideObject()
        tag = algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
        self.update(filter)
        for port in range(3):
            self.assertEqual(output(filter, port).GetNumberOfPoints(), 0)
        self.assertEqual(output(filter, 3).GetNumberOfRows(), 0)
        algorithm.RemoveObserver(tag)
        algorithm.SetAbortExecute(0)
        filter.Tau = 2
        self.update(filter)
        self.assertGreater(output(filter, 0).GetNumberOfPoints(), 1)

    def test_sentences(self):
        none = pv.TalwegLabelBorders(Mesh=labelled(True))
        self.assertIn("There are no labels: set Triangle Labels or Vertex Labels.",
                      self.error_of(none))
        both = pv.TalwegLabelBorders(Mesh=striped(True), TriangleLabels="row", VertexLabels="stripe")
        self.assertIn("Both Triangle Labels and Vertex Labels are set; set only one of them.",
                      self.error_of(both))
        missing = pv.TalwegLabelBorders(Mesh=labelled(True), TriangleLabels="nothing")
        self.assertIn("The mesh has no cell array nothing.", self.error_of(missing))
        # The panel lists arrays of texts, too.
        data = polydata(POINTS, TRIANGLES)
        for array in (vtkStringArray(), vtkDoubleArray()):
            array.SetName("name" if array.IsA("vtkStringArray") else "vector")
            array.SetNumberOfComponents(1 if array.IsA("vtkStringArray") else 3)
            array.SetNumberOfTuples(len(TRIANGLES))
            data.GetCellData().AddArray(array)
        for name, what in (("name", "texts; numbers are needed."),
                           ("vector", "3 components; one is needed.")):
            filter = pv.TalwegLabelBorders(Mesh=source(data), TriangleLabels=name)
            self.assertIn(f"The cell array {name} of the mesh has {what}", self.error_of(filter))
        calculator = pv.Calculator(Input=source(polydata(POINTS, TRIANGLES)),
                                   Function="coordsX", ResultArrayName="half")
        real = pv.TalwegLabelBorders(Mesh=calculator, VertexLabels="half")
        self.assertIn("Vertex Labels must be whole numbers", self.error_of(real))
        real.Tau = -2
        self.assertIn("Tau", self.error_of(real))

    def test_a_real_mesh(self):
        mesh = pv.PLYReader(FileNames=[str(real_mesh("aneurysm_14k.ply"))])
        seg = pv.Calculator(Input=mesh, ResultArrayName="seg",
                            Function="floor(coordsX/6)+10*floor(coordsZ/6)")
        filter = pv.TalwegLabelBorders(Mesh=seg, VertexLabels="seg")
        self.update(filter)
        borders = output(filter, 0)
        self.assertLess(report(borders, "curvature_after"), report(borders, "curvature_before"))
        self.assertEqual(set(cell_values(output(filter, 2), "new_label")),
                         set(values(output(filter, 1), "seg")))


if __name__ == "__main__":
    runner.main()
