"""The example that processes a folder of meshes in several processes."""

import csv
import importlib
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg

SCRIPT = support.SOURCE / "docs/examples/python_folder.py"


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.meshes, self.results = Path(folder.name) / "meshes", Path(folder.name) / "results"
        self.meshes.mkdir()

    def write(self, name, vertices, faces, drawn):
        support.write_obj(self.meshes / f"{name}.obj", vertices, faces)
        if drawn is not None:
            np.savetxt(self.meshes / f"{name}.txt", drawn, fmt="%d")

    def test_folder(self):
        vertices, faces = support.hills()
        drawn = support.staircase()
        self.write("one", vertices, faces, drawn)
        self.write("two", vertices * 3, faces, drawn[::-1])
        self.write("broken", vertices, np.vstack([faces, faces[:1]]), drawn)
        self.write("gap", vertices, faces, [5, 900])
        self.write("undrawn", vertices, faces, None)
        (self.meshes / "garbage.ply").write_text("ply of sorts")
        (self.meshes / "garbage.txt").write_text("1\n2\n")
        (self.meshes / "notes.md").write_text("not a mesh")
        done = subprocess.run([sys.executable, SCRIPT, self.meshes, self.results, "2"], text=True,
                              check=True, capture_output=True)
        with open(self.results / "summary.csv", newline="", encoding="utf-8") as table:
            rows = {row["mesh"]: row for row in csv.DictReader(table)}
        self.assertEqual(list(rows), ["broken.obj", "gap.obj", "garbage.ply", "one.obj", "two.obj",
                                      "undrawn.obj"])
        self.assertEqual([line.split()[0] for line in done.stdout.splitlines()], list(rows))
        for name, scale in (("one", 1), ("two", 3)):
            row = rows[f"{name}.obj"]
            self.assertEqual((row["error"], int(row["faces"])), ("", len(faces)))
            expected = talweg.smooth((vertices, faces), drawn).report.length_after
            self.assertAlmostEqual(float(row["length_after"]) / scale, expected, places=6)
            self.assertTrue((self.results / f"{name}.vtp").is_file())
        self.assertRegex(rows["gap.obj"]["error"], "Vertices 5 and 900, .* share no edge")
        self.assertRegex(rows["undrawn.obj"]["error"], "no drawing undrawn.txt")
        self.assertRegex(rows["garbage.ply"]["error"], "^Cannot read .*garbage.ply: the file ends where")
        with self.assertRaises(talweg.BadMesh) as broken:
            talweg.Mesh(vertices, np.vstack([faces, faces[:1]]))
        self.assertEqual(rows["broken.obj"]["error"],
                         f"{self.meshes / 'broken.obj'}: {broken.exception}")
        try:
            importlib.import_module("matplotlib")
        except ImportError:
            return
        self.assertEqual(sorted(path.name for path in self.results.glob("*.png")),
                         ["one.png", "two.png"])

    def test_usage(self):
        done = subprocess.run([sys.executable, SCRIPT], text=True, check=False, capture_output=True)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.strip(), "usage: python_folder.py MESHES RESULTS [JOBS]")


if __name__ == "__main__":
    unittest.main()
