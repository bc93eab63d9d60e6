"""Runs the Python blocks of docs/python.md and README.md, in order, and the example with pictures."""

import contextlib
import importlib.util
import io
import os
import re
import runpy
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import support

BLOCK = re.compile(r"(?:^<!-- (not run|needs): ([^\n]+) -->\n)?^```python\n(.*?)^```",
                   re.DOTALL | re.MULTILINE)


def is_missing(module):
    return importlib.util.find_spec(module) is None


class Docs(unittest.TestCase):
    def test_blocks(self):
        folder = tempfile.TemporaryDirectory()  # for the files that the page writes
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        names, printed = {}, io.StringIO()
        for page in ("docs/python.md", "README.md"):  # the README takes its mesh from the page
            text = (support.SOURCE / page).read_text()
            blocks = [(text.count("\n", 0, found.start(3)), found)
                      for found in BLOCK.finditer(text) if found.group(1) != "not run"]
            self.assertGreater(len(blocks), 0, page)
            for line, found in blocks:
                code = found.group(3)
                with self.subTest(f"{page}:{line}"), contextlib.redirect_stdout(printed):
                    if found.group(1) == "needs" and is_missing(found.group(2)):
                        self.skipTest(f"no {found.group(2)} (Debian: python3-{found.group(2)})")
                    exec(compile("\n" * line + code, page, "exec"), names)  # pylint: disable=exec-used
        # The page quotes this sentence.
        self.assertIn("3 Vertices 5 and 900, at positions 0 and 1", printed.getvalue())
        self.assertIn(printed.getvalue().strip().splitlines()[-1],
                      (support.SOURCE / "docs/python.md").read_text())

    def test_example(self):
        try:
            import matplotlib  # pylint: disable=import-outside-toplevel,unused-import
        except ImportError:
            self.skipTest("no matplotlib (Debian: python3-matplotlib)")
        script = support.SOURCE / "docs/examples/python_terrain.py"
        with tempfile.TemporaryDirectory() as folder, \
                mock.patch.object(sys, "argv", [str(script), folder]), \
                contextlib.redirect_stdout(io.StringIO()):
            made = runpy.run_path(str(script))
            for picture in ("python_terrain.png", "python_fields.png"):
                self.assertEqual((Path(folder) / picture).read_bytes()[:4], b"\x89PNG")
        # The claims of the example.
        report = made["smoothed"][1].report
        self.assertLess(report.curvature_after, report.curvature_before / 10)
        self.assertLessEqual(made["within"].report.deviation_to_drawn_max, 30)
        self.assertLessEqual(made["within"].report.deviation_from_drawn_max, 30)


if __name__ == "__main__":
    unittest.main()
