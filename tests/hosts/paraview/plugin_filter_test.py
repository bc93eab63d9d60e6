"""Talweg Plugin runs a decimation plugin written with OpenMesh (docs/examples)."""

import unittest

from vtkmodules.vtkCommonCore import vtkIntArray

import runner
from support import (Case, cell_values, lines_of, output, places, polydata, pv, report, source,
                     values, wavy_sheet)

SIDE = 30
POINTS, TRIANGLES = wavy_sheet(SIDE)
ROW = [SIDE * (SIDE // 2) + k for k in range(SIDE)]  # a chain of edges


def sheet():
    data = polydata(POINTS, TRIANGLES)
    numbers = vtkIntArray()
    numbers.SetName("number")
    for k in range(len(POINTS)):
        numbers.InsertNextValue(k)
    data.GetPointData().AddArray(numbers)
    return source(data)


def along(vertices):
    return source(polydata([POINTS[v] for v in vertices], lines=[range(len(vertices))]))


def decimate(curve, parameters):
    return pv.TalwegPlugin(Mesh=sheet(), Curve=curve, Plugin="example.decimate",
                           Parameters=parameters)


class Decimate(Case):
    def made(self, filter):
        self.update(filter)
        data = output(filter, 0)
        self.assertEqual(data.GetNumberOfBlocks(), 1)
        return data.GetBlock(0)

    def test_the_curve_stays_a_chain_of_edges(self):
        filter = decimate(along(ROW), "share=0.1")
        mesh = self.made(filter)
        self.assertLess(mesh.GetNumberOfCells(), 0.5 * len(TRIANGLES))
        self.assertEqual(report(output(filter, 0), "faces"), mesh.GetNumberOfCells())
        self.assertEqual([POINTS[int(k)] for k in values(mesh, "number")], places(mesh))
        chains = output(filter, 1)
        (line,) = lines_of(chains)
        self.assertEqual([chains.GetPoint(k) for k in line], [POINTS[v] for v in ROW])
        self.assertEqual(len(cell_values(mesh, "origin_cell")), mesh.GetNumberOfCells())

    def test_changes_are_seen(self):
        filter = decimate(along(ROW), "share=0.9")
        many = self.made(filter).GetNumberOfCells()
        filter.Parameters = "share=0.4"
        few = self.made(filter).GetNumberOfCells()
        self.assertLess(few, many)
        filter.Plugin, filter.Parameters = "talweg.cut", "open=1 split=1 cap=none"
        self.update(filter)
        self.assertEqual(output(filter, 0).GetNumberOfBlocks(), 2)

    def test_wrong_input(self):
        self.assertIn("share", self.error_of(decimate(along(ROW), "share=2")))
        self.assertIn("has no parameter tau", self.error_of(decimate(along(ROW), "tau=2")))
        self.assertIn("is not of the form", self.error_of(decimate(along(ROW), "share")))
        self.assertIn("needs one number", self.error_of(decimate(along(ROW), "share=")))
        for plugin, sentence in (("nobody.there", "There is no plugin nobody.there"),
                                 ("talweg.smooth", "talweg.smooth makes no meshes")):
            filter = pv.TalwegPlugin(Mesh=sheet(), Curve=along(ROW), Plugin=plugin)
            self.assertIn(sentence, self.error_of(filter))
        three = [(0, 1, 2), (1, 0, 3), (0, 1, 4)]
        mesh = source(polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], three))
        filter = pv.TalwegPlugin(Mesh=mesh, Curve=along(ROW), Plugin="example.decimate")
        self.assertIn("Face 2 has the edge", self.error_of(filter))


if __name__ == "__main__":
    runner.main()
