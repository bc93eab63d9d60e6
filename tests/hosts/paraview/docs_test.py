"""The Python blocks of docs/paraview.md, in a folder with their input files."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import runner

PAGE = pathlib.Path(__file__).parents[3] / "docs" / "paraview.md"


@unittest.skipUnless(os.environ.get("TALWEG_SCENES"), "no talweg-scenes (TALWEG_BUILD_DEMO)")
class Docs(unittest.TestCase):
    def test_blocks(self):
        text = PAGE.read_text()
        blocks = [(text.count("\n", 0, found.start(1)), found[1])
                  for found in re.finditer(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)]
        self.assertGreater(len(blocks), 0)
        names = {"talweg_so": os.environ["TALWEG_PARAVIEW"]}
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            self.addCleanup(os.chdir, here)
            subprocess.run([os.environ["TALWEG_SCENES"], "."], check=True)
            through = pathlib.Path("vessel.through").read_text().split()
            subprocess.run([os.environ["TALWEG_DRIVER"], "draw", "vessel.ply", *through, "-o",
                            "drawn.vtp"], check=True)
            for line, code in blocks:
                exec(compile("\n" * line + code, PAGE.name, "exec"), names)
            for file in ("smooth.vtp", "labelled.vtp"):
                self.assertGreater(os.path.getsize(file), 1000)
            os.chdir(here)
        self.assertLessEqual(
            names["report"].GetArray("deviation_to_drawn_max").GetValue(0), 0.02)
        self.assertGreater(names["pieces"].GetNumberOfBlocks(), 0)
        for filter in ("through", "points", "borders", "repaired"):
            names[filter].UpdatePipeline()
            data = names["servermanager"].Fetch(names[filter], idx=0)
            self.assertGreater(data.GetNumberOfPoints(), 2, filter)


if __name__ == "__main__":
    runner.main()
