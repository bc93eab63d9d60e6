"""Plugins by others: runs a decimation written with OpenMesh (docs/examples)."""

import os
import unittest

import numpy as np

import support
import talweg

PLUGIN = "example.decimate"
SKIPPED = "the example was not built"


@unittest.skipUnless("TALWEG_EXAMPLES" in os.environ, SKIPPED)
class Decimate(unittest.TestCase):
    def setUp(self):
        vertices, faces = support.hills()
        self.vertices, self.faces = vertices, faces
        self.mesh = talweg.Mesh(vertices, faces, plugin=PLUGIN,
                                vertex_attributes={"place": vertices, "number": np.arange(len(vertices))},
                                face_attributes={"number": np.arange(len(faces), dtype=np.int32)})
        self.curve = talweg.Mesh(vertices, faces).smooth(support.staircase(), 2).curve

    def run_on(self, curve, **parameters):
        work = self.mesh.workspace(curve, plugin=PLUGIN, **parameters)
        result = work.run(meshes=True)
        self.assertEqual(len(result.meshes), 1)
        return result, result.meshes[0]

    def test_the_curves_faces_are_there_to_the_bit(self):
        result, made = self.run_on(self.curve, share=0.5)
        self.assertEqual(result.total.faces, len(made.faces))
        self.assertLess(len(made.faces), len(self.faces))
        there = {tuple(made.vertices[f].tobytes() for f in face) for face in made.faces}
        rotated = there | {(b, c, a) for a, b, c in there} | {(c, a, b) for a, b, c in there}
        for face in self.curve.faces:
            corners = tuple(self.vertices[v].tobytes() for v in self.faces[face])
            self.assertIn(corners, rotated)
        talweg.Mesh(made.vertices, made.faces)  # the result is a surface

    def test_chains_of_edges_and_attributes_stay(self):
        row = talweg.Mesh(self.vertices, self.faces).draw(support.staircase()[[0, -1]], straight=False).vertices
        _, made = self.run_on(row, share=0.1)
        np.testing.assert_array_equal(made.vertex_attributes["place"], made.vertices)
        numbers = made.vertex_attributes["number"]
        np.testing.assert_array_equal(self.vertices[numbers], made.vertices)
        np.testing.assert_array_equal(made.origin.vertices[:, 0], numbers)
        np.testing.assert_array_equal(made.face_attributes["number"], made.origin.faces)
        (chain,) = made.chains
        np.testing.assert_array_equal(numbers[chain.vertices], row)
        self.assertLess(len(made.faces), 0.3 * len(self.faces))

    def test_two_workspaces_share_the_mesh(self):
        few = self.run_on(self.curve, share=0.3)[1]
        many = self.run_on(self.curve, share=0.9)[1]
        self.assertLess(len(few.faces), len(many.faces))

    def test_wrong_input(self):
        with self.assertRaisesRegex(talweg.BadUsage, "share"):
            self.run_on(self.curve, share=2)
        with self.assertRaisesRegex(talweg.BadCurve, "vertex 99999"):
            self.run_on([0, 99999])
        with self.assertRaisesRegex(talweg.BadMesh, "Face 2 has the edge"):
            talweg.Mesh(np.eye(5, 3), [[0, 1, 2], [1, 0, 3], [0, 1, 4]], plugin=PLUGIN)

    def test_a_progress_that_says_no_cancels(self):
        with self.assertRaises(talweg.Cancelled):
            self.mesh.workspace(self.curve, plugin=PLUGIN, share=0).run(
                meshes=True, progress=lambda stage, done: False)


class OfOurs(unittest.TestCase):
    def test_meshes_of_any_plugin(self):
        vertices, faces = support.hills()
        mesh = talweg.Mesh(vertices, faces, vertex_attributes={"x": vertices[:, 0]})
        curve = mesh.smooth(support.staircase(), 2).curve
        (made,) = mesh.workspace(curve, plugin="talweg.cut").run(meshes=True).meshes
        np.testing.assert_array_equal(made.faces, mesh.cut(curve).mesh.faces)
        np.testing.assert_allclose(made.vertex_attributes["x"], made.vertices[:, 0])
        self.assertEqual(mesh.workspace(curve).run().meshes, [])


if __name__ == "__main__":
    unittest.main()
