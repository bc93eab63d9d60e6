"""Talweg Repair: a mesh that is not a surface becomes one, with its arrays and a report of the changes."""

import unittest

from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray

import runner
from support import Case, cell_values, output, polydata, pv, real_mesh, report, source, told, values

# Two triangles that should share an edge, and a repeated triangle; two vertices occur twice.
POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
TRIANGLES = [(0, 1, 2), (3, 4, 5), (4, 5, 3)]


def broken():
    data = polydata(POINTS, TRIANGLES)
    numbers, names = vtkIntArray(), vtkStringArray()
    numbers.SetName("number")
    names.SetName("name")
    for k in range(len(POINTS)):
        numbers.InsertNextValue(100 + k)
    for k in range(len(TRIANGLES)):
        names.InsertNextValue(f"cell {k}")
    data.GetPointData().AddArray(numbers)
    data.GetCellData().AddArray(names)
    return source(data)


class Repair(Case):
    def test_a_surface_with_its_arrays(self):
        filter = pv.TalwegRepair(Mesh=broken())
        self.update(filter)
        data = output(filter, 0)
        used = {data.GetCell(k).GetPointId(i) for k in range(2) for i in range(3)}
        self.assertEqual((len(used), data.GetNumberOfPolys()), (4, 2))
        for k, number in enumerate(values(data, "number")):
            self.assertEqual(data.GetPoint(k), POINTS[int(number) - 100])
        names = data.GetCellData().GetAbstractArray("name")
        self.assertEqual([names.GetValue(k) for k in range(2)], ["cell 0", "cell 1"])
        self.assertEqual(cell_values(data, "origin_cell"), [0, 1])

    def test_the_changes_are_in_the_field_data(self):
        filter = pv.TalwegRepair(Mesh=broken())
        self.update(filter)
        data = output(filter, 0)
        self.assertEqual(report(data, "verdict"), "repairable")
        self.assertEqual(report(data, "repair.verdict"), "usable")
        changes = report(data, "repair.changes")
        self.assertEqual(len(changes), 2)
        self.assertIn("2 vertices were welded", changes[0])
        self.assertEqual(report(data, "repair.duplicate_faces.count"), 1)

    def test_without_repair_the_mesh_is_inspected(self):
        filter = pv.TalwegRepair(Mesh=broken(), Repair=0)
        self.update(filter)
        data = output(filter, 0)
        self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (6, 3))
        self.assertEqual(report(data, "verdict"), "repairable")
        self.assertEqual(report(data, "defects.duplicate_faces.count"), 1)
        self.assertIsNone(data.GetFieldData().GetAbstractArray("repair.verdict"))

    def test_the_outcome_tells_what_was_done(self):
        filter = pv.TalwegRepair(Mesh=broken())
        self.update(filter)
        self.assertEqual(told(filter).split("\n"), report(output(filter, 0), "repair.changes"))
        again = pv.TalwegRepair(Mesh=filter)
        self.update(again)
        self.assertEqual(told(again), "The mesh needs no repair.")
        filter.Repair = 0
        self.update(filter)
        self.assertRegex(told(filter), "^Not repaired. .+")
        again.Repair = 0
        filter.Repair = 1
        self.update(again)
        self.assertEqual(told(again), "Not repaired. The mesh is a consistently oriented manifold surface.")

    def test_steps(self):
        filter = pv.TalwegRepair(Mesh=broken(), RepairWeld=0)
        self.update(filter)
        self.assertEqual(report(output(filter, 0), "repair.welded_vertices.count"), 0)
        filter.RepairWeld = 1
        self.update(filter)
        self.assertEqual(report(output(filter, 0), "repair.welded_vertices.count"), 2)

    def test_sentences(self):
        for data, sentence in ((polydata(POINTS), "cannot be repaired"),
                               (polydata(POINTS, [(0, 1)]), "Cell 0 of the mesh has 2 corners"),
                               (polydata([(0, 0, 0), (float("nan"), 0, 0), (0, 1, 0)], [(0, 1, 2)]),
                                "cannot be repaired")):
            self.assertIn(sentence, self.error_of(pv.TalwegRepair(Mesh=source(data))))

    def test_a_real_mesh_that_other_filters_refuse(self):
        mesh = pv.PLYReader(FileNames=[str(real_mesh("car_nonmanifold_251k.ply"))])
        filter = pv.TalwegRepair(Mesh=mesh)
        self.update(filter)
        self.assertEqual(report(output(filter, 0), "repair.verdict"), "usable")
        again = pv.TalwegRepair(Mesh=filter)
        self.update(again)
        self.assertEqual(report(output(again, 0), "verdict"), "usable")
        self.assertEqual(output(again, 0).GetNumberOfPolys(), output(filter, 0).GetNumberOfPolys())


if __name__ == "__main__":
    runner.main()
