"""Functions take a mesh first; and the package's public names."""

import inspect
import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np
import support
import talweg


class AnObject:  # an object such as trimesh's meshes
    def __init__(self, vertices, faces):
        self.vertices, self.faces = vertices, faces


class Signature(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        cls.mesh = talweg.Mesh(cls.vertices, cls.faces)
        cls.drawn = support.staircase()
        cls.calls = {  # name -> (first argument after the mesh, further arguments, numbers of the result)
            "smooth": (cls.drawn, {"tau": 2}, lambda result: result.curve.positions),
            "draw": (cls.drawn[::20], {"exact": False}, lambda curve: curve.vertices),
            "geodesic": (cls.drawn, {}, lambda result: result.curve.positions),
            "distance": (cls.drawn, {}, lambda result: result.distance)}

    def test_every_kind_of_mesh(self):
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("error", DeprecationWarning)
            path = Path(folder) / "hills.ply"
            talweg.write_mesh(path, self.mesh)
            kinds = [self.mesh, (self.vertices, self.faces), [self.vertices, self.faces],
                     (self.vertices.tolist(), self.faces.tolist()), path, str(path),
                     AnObject(self.vertices, self.faces)]
            for name, (first, more, numbers) in self.calls.items():
                expected = numbers(getattr(self.mesh, name)(first, **more))
                for kind in kinds:
                    with self.subTest(name, kind=type(kind)):
                        got = numbers(getattr(talweg, name)(kind, first, **more))
                        np.testing.assert_array_equal(got, expected)

    def test_tau_may_be_the_third(self):
        for mesh in (self.mesh, (self.vertices, self.faces)):
            np.testing.assert_array_equal(talweg.smooth(mesh, self.drawn, 3).curve.positions,
                                          self.mesh.smooth(self.drawn, 3).curve.positions)

    def test_arrays_apart_are_taken_with_a_warning(self):
        v, f = self.vertices, self.faces
        for name, (first, more, numbers) in self.calls.items():
            function, word = getattr(talweg, name), "points" if name == "draw" else "curve"
            expected = numbers(getattr(self.mesh, name)(first, **more))
            for given, named in (((v, f, first), {}), ((v, f), {word: first}),
                                 ((v.tolist(), f.tolist(), first), {}), ((v,), {"faces": f, word: first}),
                                 ((), {"vertices": v, "faces": f, word: first}),
                                 ((AnObject(v, f), None, first), {})):
                with self.subTest(name, given=len(given), named=list(named)):
                    with self.assertWarnsRegex(DeprecationWarning, rf"talweg\.{name}\(\(vert") as caught:
                        got = function(*given, **named, **more)
                    np.testing.assert_array_equal(numbers(got), expected)
                    self.assertEqual(Path(caught.filename).name, Path(__file__).name)

    def test_faces_that_are_forgotten(self):
        with self.assertRaisesRegex(talweg.BadMesh, r"a pair of vertices \(n, 3\) and faces .*ndarray"):
            talweg.smooth(self.vertices, self.drawn)

    def test_help_has_the_new_form(self):
        for name in self.calls:
            self.assertEqual(next(iter(inspect.signature(getattr(talweg, name)).parameters)), "mesh")

    def test_dir_shows_the_public_names_only(self):
        shown = subprocess.run(  # in a new process without imports
            [sys.executable, "-c", "import talweg; print(*(n for n in dir(talweg) if n[0] != '_'))"],
            check=True, capture_output=True, text=True).stdout.split()
        self.assertEqual(set(shown), set(talweg.__all__) - {"__version__"})
        for name in shown:
            self.assertFalse(inspect.ismodule(getattr(talweg, name)), name)


if __name__ == "__main__":
    unittest.main()
