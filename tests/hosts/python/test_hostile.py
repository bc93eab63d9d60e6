"""Plugins with nonsense as results, or without an end: each call raises an error, and the program
continues."""

import os
import signal
import subprocess
import sys
import textwrap
import unittest

import numpy as np

import support
import talweg

FAULTS = {
    "nan_position": "positions has a number in row 1 that is not finite",
    "infinite_position": "positions has a number in row 2 that is not finite",
    "face_out_of_range": "faces has 1000000000 in row 1, but there are 242",
    "vertex_out_of_range": "vertices has 77777777 in row 2, but there are 144",
    "nan_weights": "barycentrics has a number in row 1 that is not finite",
    "large_weights": "barycentrics has weights that are negative or do not add up to 1",
    "few_positions": "positions has 2 rows, not 3",
    "few_weights": "barycentrics has 1 rows, not 3",
    "no_points": "A curve has no points",
    "null_data": "gave an invalid result",
    "short_field": "A curve's field toy has 2 rows, not 3",
    "null_name": "gave an invalid result",
    "null_fields": "gave an invalid result",
    "curve_number": "The report's entry value is about curve 1000000000000, but there are 1",
    "null_key": "A key of the report is null",
    "null_text": "A text of the report is null",
    "no_value": "The report's entry value has no single value",
    "short_mesh_field": "The field field has 143 rows, not 144",
    "mesh_corner": "triangles has 99 in row 0, but there are 3",
    "goes_on": "positions has a number in row 1 that is not finite",
}

NEVER_ENDS = textwrap.dedent("""
    import os, signal, threading
    import support, talweg

    vertices, faces = support.hills(12)
    mesh = talweg.Mesh(vertices, faces, plugin="toy.hostile")
    work = mesh.workspace([0, 1], plugin="toy.hostile", fault="never_runs")
    for seconds in (0.3, 0.4, 1.2):  # the second comes too soon to be meant
        threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT)).start()
    try:
        work.run()
    except KeyboardInterrupt:
        print("given up")
    try:
        work.run()
    except talweg.Error as error:
        print(error)
    other = talweg.Mesh(vertices, faces).workspace([13, 14, 26, 38])
    print(len(other.run().curves), "curve")
""")


class Hostile(unittest.TestCase):
    def setUp(self):
        vertices, faces = support.hills(12)
        self.mesh = talweg.Mesh(vertices, faces, plugin="toy.hostile")

    def run_hostile(self, fault):
        work = self.mesh.workspace([0, 1], plugin="toy.hostile", fault=fault)
        return work.run(point_fields=True, vertex_fields=True, meshes=True)

    def test_valid_results_are_accepted(self):
        result = self.run_hostile("none")
        np.testing.assert_array_equal(result.curve.vertices, [0, -1, -1])
        self.assertEqual(result.total.more["value"], 1)
        self.assertEqual(len(result.meshes), 1)

    def test_nonsense_is_an_error_that_names_it(self):
        for fault, words in FAULTS.items():
            with self.subTest(fault):
                with self.assertRaises(talweg.Internal) as caught:
                    self.run_hostile(fault)
                self.assertIn("The plugin toy.hostile gave an invalid result", str(caught.exception))
                self.assertIn(words, str(caught.exception))

    def test_the_second_ctrl_c_abandons_a_run_that_never_returns(self):
        folders = [os.path.dirname(os.path.abspath(__file__)), os.environ.get("PYTHONPATH", "")]
        done = subprocess.run([sys.executable, "-c", NEVER_ENDS], capture_output=True, text=True,
                              timeout=60, check=False,
                              env={**os.environ, "PYTHONPATH": os.pathsep.join(folders)})
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual(lines[0], "given up")
        self.assertIn("The last call of the plugin toy.hostile has not ended", lines[1])
        self.assertEqual(lines[2], "1 curve")

    def test_it_ends_a_program_that_catches_nothing(self):
        script = NEVER_ENDS.split("try:")[0] + "work.run()\n"
        folders = [os.path.dirname(os.path.abspath(__file__)), os.environ.get("PYTHONPATH", "")]
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True,
                              timeout=60, check=False,
                              env={**os.environ, "PYTHONPATH": os.pathsep.join(folders)})
        self.assertIn("KeyboardInterrupt", done.stderr)
        self.assertEqual(done.returncode, -signal.SIGINT)


if __name__ == "__main__":
    unittest.main()
