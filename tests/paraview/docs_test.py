"""The Python blocks of docs/paraview.md, in a folder with the files that they name."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from support import wavy_sheet

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "paraview.md"


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
            self.write_mesh()
            subprocess.run([os.environ["TALWEG_DRIVER"], "draw", "vessel.ply", "--through",
                            "12,845,901", "-o", "drawn.vtp"], check=True)
            for line, code in blocks:
                exec(compile("\n" * line + code, PAGE.name, "exec"), names)
            self.assertGreater(os.path.getsize("smooth.vtp"), 1000)
            os.chdir(here)
        self.assertLessEqual(
            names["report"].GetArray("deviation_to_drawn_max").GetValue(0), 0.05)
        for filter in ("through", "points"):
            names[filter].UpdatePipeline()
            data = names["servermanager"].Fetch(names[filter], idx=0)
            self.assertGreater(data.GetNumberOfPoints(), 2, filter)

    def write_mesh(self):
        points, triangles = wavy_sheet(32)
        with open("vessel.ply", "w") as out:
            out.write("ply\nformat ascii 1.0\n"
                      f"element vertex {len(points)}\n"
                      "property float x\nproperty float y\nproperty float z\n"
                      f"element face {len(triangles)}\nproperty list uchar int vertex_indices\n"
                      "end_header\n")
            for point in points:
                out.write("%.9g %.9g %.9g\n" % point)
            for triangle in triangles:
                out.write("3 %d %d %d\n" % triangle)


if __name__ == "__main__":
    unittest.main()
