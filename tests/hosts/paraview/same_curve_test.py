"""ParaView gives the driver's curve, bit for bit, for the same mesh, drawing and parameters.

The driver's JSON has 17 digits, so its numbers are exact.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkIdList

import runner
from support import (Case, lines_of, output, places, polydata, pv, real_mesh, reference_curve,
                     source, values, wavy_sheet)


def write_obj(data, file):
    """Writes the filter's input mesh with all digits."""
    corners = vtkIdList()
    with open(file, "w") as out:
        for k in range(data.GetNumberOfPoints()):
            out.write("v %.17g %.17g %.17g\n" % data.GetPoint(k))
        for k in range(data.GetNumberOfCells()):
            data.GetCellPoints(k, corners)
            ids = [corners.GetId(i) + 1 for i in range(corners.GetNumberOfIds())]
            out.write("f " + " ".join(map(str, ids)) + "\n")


class SameCurve(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def driver(self, *arguments):
        subprocess.run([os.environ["TALWEG_DRIVER"], "-q", *map(str, arguments)], check=True)

    def smoothed(self, mesh, curve, *options):
        result = self.folder / "smooth.json"
        self.driver("smooth", mesh, "--curve", curve, "-o", result, *options)
        return json.loads(result.read_text())["curves"]

    def ids_file(self, ids):
        file = self.folder / "drawn.txt"
        file.write_text("\n".join(map(str, ids)) + "\n")
        return file

    def check(self, filter, expected):
        data = self.curve_of(filter)
        points, faces, weights = places(data), values(data, "face"), values(data, "barycentric")
        lines = lines_of(data)
        self.assertEqual(len(lines), len(expected))
        for line, curve in zip(lines, expected):
            self.assertEqual(line[0] == line[-1], curve["closed"])
            if curve["closed"]:
                line = line[:-1]
            self.assertEqual([int(faces[k]) for k in line], [p["face"] for p in curve["points"]])
            self.assertEqual([list(weights[k]) for k in line],
                             [p["barycentric"] for p in curve["points"]])
            self.assertEqual([list(points[k]) for k in line], [p["xyz"] for p in curve["points"]])

    PARAMETERS = (
        ({}, ()),
        ({"Tau": 3.7}, ("--tau", "3.7")),
        ({"Potential": "paper", "Relax": 5}, ("--potential", "paper", "--relax", "5")),
        ({"Finish": "taut", "CapCorners": 0, "PhaseTurns": 1, "Threads": 1},
         ("--finish", "taut", "--no-cap-corners", "--phase-turns", "1")),
    )

    def check_ids(self, mesh_file, reader, ids, parameters=PARAMETERS):
        drawn = self.ids_file(ids)
        for properties, options in parameters:
            with self.subTest(**properties):
                filter = pv.TalwegSmoothVertices(Mesh=reader, PointIds=" ".join(map(str, ids)),
                                               **properties)
                run = self.run_plugin if "--no-cap-corners" in options else self.smoothed
                self.check(filter, run(mesh_file, drawn, *options))

    def run_plugin(self, mesh, curve, *options):
        """Runs the driver with options that `talweg smooth` does not have."""
        result = self.folder / "run.json"
        self.driver("run", "talweg.smooth", mesh, "--curve", curve, "-o", result, *options)
        return json.loads(result.read_text())["curves"]

    def test_generated_in_double_precision(self):
        points, triangles = wavy_sheet(30)
        data = polydata(points, triangles)
        mesh = self.folder / "sheet.obj"
        write_obj(data, mesh)
        ids = [30 * row + (10 if row % 2 else 12) for row in range(2, 28)]
        drawn = self.folder / "edges.txt"
        self.driver("draw", mesh, "--through", ",".join(map(str, ids)), "-o", drawn)
        for properties, options in self.PARAMETERS + (
                ({"Slack": 0.05, "Tau": 2}, ("--slack", "0.05", "--tau", "2")),
                ({"MaxDeviation": 0.03}, ("--max-deviation", "0.03")),
                ({"Pin": f"{ids[8]} {ids[9]}"}, ("--pin", f"{ids[8]},{ids[9]}"))):
            with self.subTest(**properties):
                filter = pv.TalwegSmoothVertices(Mesh=source(data),
                                               PointIds=" ".join(map(str, ids)), **properties)
                run = self.run_plugin if "--no-cap-corners" in options else self.smoothed
                self.check(filter, run(mesh, drawn, *options))

    def two_curves(self):
        """A mesh and an open and a closed curve on it: two files for the driver, two sources."""
        points, triangles = wavy_sheet(30)
        data = polydata(points, triangles)
        mesh = self.folder / "sheet.obj"
        write_obj(data, mesh)
        drawn = [[(0.11, 0.2, 0.02), (0.31, 0.27, 0.05), (0.52, 0.21, 0.0), (0.83, 0.3, 0.1)],
                 [(0.2, 0.5, 0), (0.5, 0.55, 0.1), (0.6, 0.8, 0), (0.25, 0.75, 0)]]
        obj = self.folder / "drawn.obj"
        with open(obj, "w") as out:
            for point in drawn[0] + drawn[1]:
                out.write("v %.17g %.17g %.17g\n" % point)
            out.write("l 1 2 3 4\nl 5 6 7 8 5\n")
        lines = polydata(drawn[0] + drawn[1], lines=[(0, 1, 2, 3), (4, 5, 6, 7, 4)])
        return mesh, obj, source(data), source(lines)

    def test_positions_of_two_curves(self):
        mesh, obj, surface, lines = self.two_curves()
        self.check(pv.TalwegSmoothCurve(Mesh=surface, Curve=lines), self.smoothed(mesh, obj))

    def test_options_of_each_of_two_curves(self):
        mesh, obj, surface, lines = self.two_curves()
        filter = pv.TalwegSmoothCurve(Mesh=surface, Curve=lines)
        taus = self.smoothed(mesh, obj, "--tau", "0.1,4")
        for others in ("0.1", "4", "4,0.1"):  # otherwise the comparison would prove nothing
            self.assertNotEqual(taus, self.smoothed(mesh, obj, "--tau", others))
        for properties, of_the_plugin, of_smooth in (
                ({"Taus": "0.1, 4"}, ("--taus", "0.1,4"), ("--tau", "0.1,4")),
                ({"Taus": "", "Slacks": "-1 0.05"}, ("--slacks=-1,0.05",),
                 ("--slack", "auto,0.05")),
                ({"Slacks": "", "Finishes": "1;0"}, ("--finishes", "1,0"),
                 ("--finish", "taut,fair")),
                ({"Finishes": ""}, (), ())):
            with self.subTest(**properties):
                pv.SetProperties(filter, **properties)
                self.check(filter, self.run_plugin(mesh, obj, *of_the_plugin))
                self.check(filter, self.smoothed(mesh, obj, *of_smooth))

    def test_single_precision_points_against_the_rounded_mesh(self):
        points, triangles = wavy_sheet(30)
        data = polydata(points, triangles, precision="float")
        mesh = self.folder / "rounded.obj"
        write_obj(data, mesh)
        self.check_ids(mesh, source(data), [30 * ((k + 1) // 2) + k // 2 + 3 for k in range(2, 50)],
                       self.PARAMETERS[:2])

    def test_fandisk(self):
        file = real_mesh("fandisk_14k.ply")
        self.check_ids(file, pv.PLYReader(FileNames=[str(file)]), reference_curve("fandisk_14k"))

    def test_closed_loop_on_armadillo(self):
        file = real_mesh("armadillo_86k.ply")
        self.check_ids(file, pv.PLYReader(FileNames=[str(file)]),
                       reference_curve("armadillo_86k_loop_large"), self.PARAMETERS[:2])

    def test_tooth(self):
        file = real_mesh("tooth_ct_119k.ply")
        self.check_ids(file, pv.PLYReader(FileNames=[str(file)]), reference_curve("tooth_ct_119k"),
                       self.PARAMETERS[:1])

    def test_double_precision_file_that_paraview_rounds(self):
        reader = pv.PLYReader(FileNames=[str(real_mesh("terrain_utm_21k.ply"))])
        reader.UpdatePipeline()
        rounded = self.folder / "rounded.obj"
        write_obj(output(reader, 0), rounded)
        through = [500, 3000, 6000, 9000]
        drawn = self.folder / "edges.txt"
        self.driver("draw", rounded, "--through", ",".join(map(str, through)), "-o", drawn)
        self.check(pv.TalwegSmoothVertices(Mesh=reader, PointIds=" ".join(map(str, through))),
                   self.smoothed(rounded, drawn))


if __name__ == "__main__":
    runner.main()
