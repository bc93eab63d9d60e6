"""Bad input raises an exception with a code and the library's sentence; Python continues."""

import logging
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg


class Errors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        cls.drawn = support.staircase()

    def refused(self, kind, words, curve=None, vertices=None, faces=None, **parameters):
        with self.assertRaises(kind) as caught:
            talweg.smooth((self.vertices if vertices is None else vertices,
                           self.faces if faces is None else faces),
                          self.drawn if curve is None else curve, **parameters)
        self.assertIsInstance(caught.exception, talweg.Error)
        self.assertEqual(caught.exception.code, kind.code)
        self.assertIn(words, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))
        # The same process works afterwards.
        self.assertEqual(talweg.smooth((self.vertices, self.faces), self.drawn).report.termination,
                         "converged")

    def test_codes_are_those_of_the_header(self):
        for kind, code in ((talweg.BadUsage, 1), (talweg.BadMesh, 2), (talweg.BadCurve, 3),
                           (talweg.BadFile, 4), (talweg.Numerical, 5), (talweg.OutOfMemory, 6),
                           (talweg.Cancelled, 7), (talweg.Unsupported, 9), (talweg.Internal, 10)):
            self.assertEqual(kind.code, code)
            self.assertEqual(str(kind("A sentence.")), "A sentence.")

    def test_meshes(self):
        bad = self.vertices.copy()
        bad[17, 1] = np.nan
        self.refused(talweg.BadMesh, "17", vertices=bad)
        faces = self.faces.copy()
        faces[5, 2] = len(self.vertices)
        self.refused(talweg.BadMesh, "face 5 to vertex 3600 of 3600", faces=faces)
        faces[5, 2] = -1
        self.refused(talweg.BadMesh, "-1 in row 5", faces=faces)
        faces = self.faces.copy()
        faces[7] = faces[7, ::-1]
        self.refused(talweg.BadMesh, "orient", faces=faces)
        self.refused(talweg.BadMesh, "(n, 3), not (3600, 2)", vertices=self.vertices[:, :2])
        self.refused(talweg.BadMesh, "(n, 3)", faces=np.zeros((10, 4), int))
        self.refused(talweg.BadMesh, "must be integers", faces=self.faces.astype(float))
        self.refused(talweg.BadMesh, "not object", vertices=self.vertices.astype(object))
        self.refused(talweg.BadMesh, "not equally long", vertices=[[0, 0, 0], [1, 0]])
        self.refused(talweg.BadMesh, "no vertices", vertices=np.zeros((0, 3)),
                     faces=np.zeros((0, 3), int))
        with self.assertRaisesRegex(talweg.BadMesh, "not as int"):
            talweg.Mesh(5)

    def test_curves(self):
        self.refused(talweg.BadCurve, "Vertices 5 and 900", curve=[5, 900])
        self.refused(talweg.BadCurve, "999999", curve=[0, 999999])
        self.refused(talweg.BadCurve, "no points", curve=[])
        self.refused(talweg.BadCurve, "no points", curve=talweg.Curve())
        self.refused(talweg.BadCurve, "talweg.Curve", curve="drawn")
        self.refused(talweg.BadCurve, "talweg.Curve", curve=[[1, 2], [3]])
        self.refused(talweg.BadCurve, "list of talweg.Curve", curve=[[1, 2, 3], [4, 5, 6]])
        self.refused(talweg.BadCurve, "both", curve=talweg.Curve(faces=[1, 2]))
        self.refused(talweg.BadCurve, "no point 999",
                     curve=talweg.Curve(self.drawn, pins=[999]))
        self.refused(talweg.BadCurve, "inside face 0 needs three", curve=talweg.Curve(
            faces=[0, 1], barycentrics=[[0.2, 0.2, 0.2], [1, 0, 0]]))
        self.refused(talweg.BadCurve, "not finite", curve=np.full((3, 3), np.inf))

    def test_drawings(self):
        for words, points in (("two points", [4]), ("talweg.Curve", [[1], [5, 6]]),
                              ("not at a vertex", [[1.1, 1.2, 0], [5.0, 6.0, 0]])):
            with self.assertRaisesRegex(talweg.BadCurve, words):
                talweg.draw((self.vertices, self.faces), points, straight=False)
        loop = talweg.draw((self.vertices, self.faces), [70, 75, 195, 70])
        self.assertTrue(loop.closed)

    def test_parameters(self):
        self.refused(talweg.BadUsage, "no parameter tao. Did you mean tau? It has tau, slack",
                     tao=2)
        self.refused(talweg.BadUsage, "Tau (tau) must be >= 0, not -1", tau=-1)
        self.refused(talweg.BadUsage, "must be a number, not 'two'", tau="two")
        self.refused(talweg.BadUsage, "Tau (tau)", tau=float("nan"))
        self.refused(talweg.BadUsage, "whole", relax=1.5)
        self.refused(talweg.BadUsage, "one of corridor, paper", potential="papr")
        self.refused(talweg.BadUsage, "one of corridor, paper, not 3", potential=3)
        self.refused(talweg.BadUsage, "2 slacks for 3600", slack_field=[1.0, 2.0])
        self.refused(talweg.BadUsage, "slack needs the potential corridor", slack=1.0,
                     potential="paper")
        self.refused(talweg.BadUsage, "pin at vertex 0", pin=[0])
        with self.assertRaisesRegex(TypeError, "tqdm"):
            talweg.smooth((self.vertices, self.faces), self.drawn, progress=3)

    def test_a_workspace_keeps_what_it_had(self):
        work = talweg.Mesh(self.vertices, self.faces).workspace(self.drawn, tau=2.0)
        before = work.run().curve.positions
        for bad in (lambda: work.set(tau=-1), lambda: work.set(nothing=1),
                    lambda: work.set_curves([5, 900]), lambda: work.smooth(potential="x")):
            with self.assertRaises(talweg.Error):
                bad()
        self.assertEqual(work.parameters["tau"], 2.0)
        np.testing.assert_array_equal(work.run().curve.positions, before)

    def test_several_curves_have_no_single_one(self):
        vertices, faces = support.torus()
        curves = [talweg.Curve(support.ring(column=k), closed=True) for k in (5, 30)]
        result = talweg.smooth((vertices, faces), curves)
        with self.assertRaisesRegex(talweg.BadUsage, "has 2 curves.* .curves lists them"):
            result.curve  # pylint: disable=pointless-statement

    def test_nothing_is_printed(self):
        beside = self.vertices[self.drawn] + [0, 0, 0.3]
        script = ("import sys; sys.path.insert(0, sys.argv[1]); import numpy as np; "
                  "import support, talweg; v, f = support.hills(); "
                  "r = talweg.smooth((v, f), v[support.staircase()] + [0, 0, 0.3]); "
                  "assert r.report.warnings")
        done = subprocess.run([sys.executable, "-c", script, str(Path(__file__).parent)],
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        with self.assertLogs("talweg", logging.WARNING) as logs:
            talweg.smooth((self.vertices, self.faces), beside)
        self.assertIn("moved onto the mesh", logs.output[0])


class MissingPlugins(unittest.TestCase):
    def test_the_message_names_folders_and_refused_files(self):
        script = ("import talweg\ntry:\n talweg.plugin('talweg.nothing')\n"
                  "except talweg.PluginNotFound as e: print(e)")
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "talweg_broken.so").write_bytes(b"no library")
            done = subprocess.run([sys.executable, "-c", script], check=True, text=True,
                                  capture_output=True,
                                  env={**os.environ, "TALWEG_PLUGIN_PATH": folder})
        self.assertIn("There is no plugin talweg.nothing. Refused, since ", done.stdout)
        self.assertIn("Looked for in " + folder, done.stdout)
        self.assertIn("TALWEG_PLUGIN_PATH", done.stdout)
        self.assertIn("talweg_broken.so", done.stdout)


if __name__ == "__main__":
    unittest.main()
