"""Type hints: mypy --strict on the package, on the examples, and on a program that uses it."""

import importlib.util
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import support

PACKAGE = support.SOURCE / "plugins/hosts/python"

# Wrong lines end in the error that mypy must report.
PROGRAM = '''\
from typing import List, Optional
import numpy as np
import talweg

vertices, faces = np.zeros((3, 3)), np.array([[0, 1, 2]])
mesh = talweg.Mesh(vertices, faces, face_attributes={"label": [1]})
drawn: talweg.Curve = mesh.draw([0, 1], closed=False)
result: talweg.Result = mesh.smooth(drawn, tau=[1.0, None], max_deviation=2)
length: Optional[float] = result.report.length_after
curves: List[talweg.Curve] = talweg.read_curves("a.json")
talweg.show(mesh, {"drawn": drawn}, file="a.png", size=(80, 60))
result.show(view=(0, 0, 1))
talweg.plot_curvature(result, unit="mm")
largest: float = float(mesh.distance(drawn).distance.max())
again: talweg.Result = talweg.smooth((vertices, faces), talweg.draw("a.ply", [0, 1]), 2)
talweg.draw(mesh)  # error: Missing positional argument "points" in call to "draw"
talweg.write_curves("a.vtp", 3)  # error: Argument 2 to "write_curves"
result.repot  # error: "Result" has no attribute "repot"
mesh.smooth(drawn, tau="much")  # error: Argument "tau" to "smooth"
talweg.show(mesh, size=80)  # error: Argument "size" to "show"
'''


def mypy(*arguments, folder):
    return subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir", Path(folder) / "cache",
         "--no-error-summary", *arguments], cwd=folder, text=True, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if importlib.util.find_spec("mypy") is None:
            raise unittest.SkipTest("no mypy (Debian: mypy)")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name  # keeps mypy's cache, so that numpy's types are read once

    def test_package(self):
        self.assertTrue((PACKAGE / "talweg/py.typed").is_file())
        done = mypy("-p", "talweg", folder=self.folder)
        self.assertEqual((done.stdout, done.returncode), ("", 0))

    def test_example(self):
        done = mypy(support.SOURCE / "docs/examples/python_folder.py", folder=self.folder)
        self.assertEqual((done.stdout, done.returncode), ("", 0))

    def test_program(self):
        (Path(self.folder) / "program.py").write_text(PROGRAM)
        found = mypy("program.py", folder=self.folder).stdout.splitlines()
        expected = [(number, line.split("  # error: ")[1])
                    for number, line in enumerate(PROGRAM.splitlines(), 1) if "  # error: " in line]
        self.assertEqual(len(found), len(expected), found)
        for line, (number, message) in zip(found, expected):
            self.assertTrue(line.startswith(f"program.py:{number}: error: {message}"), line)


if __name__ == "__main__":
    unittest.main()
