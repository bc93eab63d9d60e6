"""The driver and this package give equal results, bit for bit, and docs/driver.md has every key of the
driver's reports."""

import json
import math
import re
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg


def names_of(parameters):
    """Options of the driver for parameters of the plugin."""
    options = []
    for name, value in parameters.items():
        text = ",".join(map(str, value)) if isinstance(value, list) else str(value)
        options += ["--" + name.replace("_", "-"), text]
    return options


def names_in(section):
    """The names in the tables of a section of docs/driver.md. After `a_max`, `_mean` means `a_mean`."""
    page = (support.SOURCE / "docs/driver.md").read_text(encoding="utf-8")
    names, last = set(), ""
    for row in re.findall(r"^\| (`.*?) \|", page.split(f"\n## {section}\n")[1].split("\n## ")[0], re.M):
        for name in re.findall(r"`(\w+)`", row):
            if name.startswith("_"):
                names.add(last.rpartition("_")[0] + name)
            else:
                last = name
                names.add(name)
    return names


class Driver(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def equal_curves(self, path, curves):
        theirs = support.driver_curves(path)
        self.assertEqual(len(theirs), len(curves))
        for (closed, faces, barycentrics, positions), ours in zip(theirs, curves):
            self.assertEqual(closed, ours.closed)
            self.assertGreater(len(faces), 10)
            np.testing.assert_array_equal(faces, ours.faces)
            np.testing.assert_array_equal(barycentrics, ours.barycentrics)
            np.testing.assert_array_equal(positions, ours.positions)

    def equal_reports(self, theirs, ours):
        compared = 0
        for key, value in theirs.items():
            if key in ("time_ms", "peak_memory_mib", "curves"):
                continue
            mine = getattr(ours, key)
            if value is None:
                self.assertFalse(math.isfinite(mine), key)
            elif isinstance(value, list):
                self.assertEqual(tuple(value), mine, key)
            else:
                self.assertEqual(value, mine, key)
            compared += 1
        self.assertGreater(compared, 30)

    def compare(self, vertices, faces, drawn, mesh_file=None, **parameters):
        if mesh_file is None:
            mesh_file = self.folder / "mesh.obj"
            support.write_obj(mesh_file, vertices, faces)
        (self.folder / "drawn.txt").write_text("\n".join(map(str, drawn)))
        support.driver(self.folder, "smooth", mesh_file, "--curve", "drawn.txt",
                       *names_of(parameters), "-o", "out.json", "--report", "report.json")
        result = talweg.smooth((vertices, faces), drawn, **parameters)
        self.equal_curves(self.folder / "out.json", result.curves)
        self.equal_reports(json.loads((self.folder / "report.json").read_text()), result.total)
        return result

    def test_open_curve(self):
        for parameters in ({}, {"tau": 0.0}, {"tau": 3.7}, {"slack": 0.4}, {"max_deviation": 1.5},
                           {"pin": [int(support.staircase()[30])]},
                           {"potential": "paper", "relax": 5},
                           {"potential": "paper", "heat_time": 1.0, "tau": 0.5}):
            with self.subTest(parameters):
                self.compare(*support.hills(), support.staircase(), **parameters)

    def test_loop(self):
        drawn = support.ring()
        result = self.compare(*support.torus(), np.append(drawn, drawn[0]), tau=2.0)
        self.assertTrue(result.curve.closed)

    def test_set_of_curves(self):
        vertices, faces = support.torus()
        support.write_obj(self.folder / "mesh.obj", vertices, faces)
        options = []
        for k, column in enumerate((5, 30)):
            drawn = support.ring(column=column)
            (self.folder / f"{k}.txt").write_text("\n".join(map(str, [*drawn, drawn[0]])))
            options += ["--curve", f"{k}.txt"]
        support.driver(self.folder, "smooth", "mesh.obj", *options, "-o", "out.json")
        curves = [talweg.Curve(support.ring(column=column), closed=True) for column in (5, 30)]
        result = talweg.smooth((vertices, faces), curves)
        self.equal_curves(self.folder / "out.json", result.curves)
        self.assertEqual(len(result.reports), 2)

    def test_positions_beside_the_surface(self):
        vertices, faces = support.hills()
        drawn = vertices[support.staircase()]
        drawn = drawn + 0.01 * np.sin(np.arange(drawn.size)).reshape(-1, 3)
        support.write_obj(self.folder / "mesh.obj", vertices, faces)
        with open(self.folder / "drawn.obj", "w", encoding="ascii") as out:
            for p in drawn.tolist():
                out.write("v %r %r %r\n" % tuple(p))
            out.write("l " + " ".join(str(k + 1) for k in range(len(drawn))) + "\n")
        support.driver(self.folder, "smooth", "mesh.obj", "--curve", "drawn.obj", "-o", "out.json")
        result = talweg.smooth((vertices, faces), drawn)
        self.equal_curves(self.folder / "out.json", result.curves)
        self.assertIn("moved onto the mesh", " ".join(result.total.warnings))

    def test_faces_and_barycentrics(self):
        vertices, faces = support.hills()
        first = talweg.smooth((vertices, faces), support.staircase()).curve
        given = talweg.Curve(faces=first.faces, barycentrics=first.barycentrics)
        support.write_obj(self.folder / "mesh.obj", vertices, faces)
        points = [{"face": int(f), "barycentric": b.tolist(), "xyz": p.tolist()} for f, b, p in
                  zip(first.faces, first.barycentrics, first.positions)]
        (self.folder / "drawn.json").write_text(json.dumps({
            "format": "talweg-curves", "version": 1,
            "curves": [{"closed": False, "points": points}]}))
        support.driver(self.folder, "smooth", "mesh.obj", "--curve", "drawn.json", "--tau", "0.5",
                       "-o", "out.json")
        self.equal_curves(self.folder / "out.json",
                          talweg.smooth((vertices, faces), given, 0.5).curves)
        # A result can be a drawing: equal to one by its faces and barycentrics.
        self.equal_curves(self.folder / "out.json",
                          talweg.smooth((vertices, faces), first, 0.5).curves)

    def test_drawing(self):
        vertices, faces = support.hills()
        support.write_obj(self.folder / "mesh.obj", vertices, faces)
        through = [5 * 60 + 5, 30 * 60 + 20, 50 * 60 + 55]
        for options, straight in (([], None), (["--edges"], False), (["--straight"], True)):
            support.driver(self.folder, "draw", "mesh.obj", "--through",
                           ",".join(map(str, through)), *options, "-o", "out.json")
            drawn = talweg.draw((vertices, faces), through, straight=straight)
            self.equal_curves(self.folder / "out.json", [drawn])
            self.assertEqual(drawn.vertices[0], through[0])

    def test_driver_md_has_every_key_of_reports(self):
        support.write_obj(self.folder / "mesh.obj", *support.hills())
        (self.folder / "drawn.txt").write_text("\n".join(map(str, support.staircase())))
        support.driver(self.folder, "smooth", "mesh.obj", "--curve", "drawn.txt", "--ridges", "0.5", "-o",
                       "out.json", "--report", "smooth.json")
        support.driver(self.folder, "measure", "mesh.obj", "drawn.txt", "out.json", "--report", "measure.json")
        for file, section in (("smooth.json", "The report"), ("measure.json", "`measure`")):
            keys = json.loads((self.folder / file).read_text()).keys()
            self.assertGreater(len(keys), 15)
            self.assertEqual(keys - names_in(section), set(), "no row in docs/driver.md")
            self.assertEqual(names_in(section) - keys - {"curves"}, set(), "docs/driver.md has keys of no report")

    def test_offset(self):
        vertices, faces = support.hills()
        support.write_obj(self.folder / "mesh.obj", vertices, faces)
        drawn = support.staircase()
        (self.folder / "drawn.txt").write_text("\n".join(map(str, drawn)))
        for options in ({}, {"side": "left"}, {"caps": "none", "tolerance": 0.01}):
            support.driver(self.folder, "offset", "mesh.obj", "--curve", "drawn.txt", "--distance",
                           "2.5", "-o", "out.json", *names_of(options))
            ours = talweg.offset((vertices, faces), drawn, 2.5, **options)
            self.equal_curves(self.folder / "out.json", ours.curves)
            for report in ours.reports:
                self.assertEqual(report.more["distance"], 2.5)
                self.assertLess(report.more["distance_off_max"], 0.011)
        twice = talweg.Mesh(vertices, faces).offset(drawn, 2.5, count=2)
        self.assertEqual([report.more["distance"] for report in twice.reports], [2.5, 5, 5])
        with self.assertRaisesRegex(talweg.BadUsage, "the farthest vertex is"):
            talweg.offset((vertices, faces), drawn, 1000)

    def test_geodesic_and_distance(self):
        vertices, faces = support.hills()
        support.write_obj(self.folder / "mesh.obj", vertices, faces)
        drawn = support.staircase()
        (self.folder / "drawn.txt").write_text("\n".join(map(str, drawn)))
        support.driver(self.folder, "run", "talweg.geodesic", "mesh.obj", "--curve", "drawn.txt",
                       "-o", "out.json")
        self.equal_curves(self.folder / "out.json", talweg.geodesic((vertices, faces), drawn).curves)
        support.driver(self.folder, "run", "talweg.distance", "mesh.obj", "--curve", "drawn.txt",
                       "--write-distance", "d.txt", "--write-potential", "p.txt")
        ours = talweg.distance((vertices, faces), drawn)
        np.testing.assert_array_equal(np.loadtxt(self.folder / "d.txt"), ours.distance)
        np.testing.assert_array_equal(np.loadtxt(self.folder / "p.txt"), ours.potential)
        self.assertEqual(ours.distance.max(), ours.distance_max)
        self.assertEqual(len(ours.slack), 1)

    def test_real_meshes(self):
        for name in ("aneurysm_14k", "fandisk_14k", "armadillo_86k"):
            with self.subTest(name):
                path = support.real_mesh(name + ".ply")
                vertices, faces = support.read_ply(path)
                self.assertEqual(vertices.dtype, np.float32)
                drawn = np.loadtxt(support.CURVES / (name + ".txt"), dtype=int)
                self.compare(vertices, faces, drawn, mesh_file=path.resolve())


if __name__ == "__main__":
    unittest.main()
