"""talweg.cut: exact cuts, interpolated attributes, and origins."""

import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg


def linear(points):
    return points @ np.array([[1, 2.0], [0, -1], [3, 1]]) + [4, 0]


class Cut(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        v, f = cls.vertices, cls.faces
        random = np.random.default_rng(0)
        cls.mesh = talweg.Mesh(
            v, f,
            vertex_attributes={"linear": linear(v), "old_label": np.arange(len(v)) + 0.5,
                               "id": np.arange(len(v)), "wide": np.tile(v, 40).astype(np.float32),
                               "colour": random.integers(0, 256, (len(v), 4), np.uint8),
                               "normal": np.tile([0.0, 0, 1], (len(v), 1)),
                               "tensor": np.tile(np.eye(2), (len(v), 1, 1))},
            face_attributes={"number": np.arange(len(f)), "even": np.arange(len(f)) % 2 == 0},
            corner_attributes={"uv": linear(v[f]), "four": linear(v[f])[..., [0, 1, 0, 1]],
                               "one": linear(v[f])[..., 0], "byte": np.full((len(f), 3, 4), 7, "u1")})
        cls.curve = cls.mesh.smooth(support.staircase(), 2).curve

    def test_it_tells_how_far_it_is_and_can_be_cancelled(self):
        mesh = talweg.Mesh(*support.hills(200), plugin="talweg.cut")
        drawn = support.staircase(200)
        seen = []
        made = mesh.cut(drawn, progress=lambda *at: seen.append(at)).mesh
        told = [fraction for stage, fraction in seen if stage == "cut"]
        self.assertGreaterEqual(len(told), 3)
        self.assertEqual((told[0], told[-1]), (0.0, 1.0))
        for last in range(len(told)):
            left = [last]

            def progress(_stage, _fraction, left=left):
                left[0] -= 1
                return left[0] >= 0

            with self.assertRaises(talweg.Cancelled):
                mesh.cut(drawn, progress=progress)
        np.testing.assert_array_equal(mesh.cut(drawn).mesh.vertices, made.vertices)

    def test_positions_are_weights_times_vertices(self):
        made = self.mesh.cut(self.curve).mesh
        self.assertGreater(len(made.vertices), len(self.vertices))
        np.testing.assert_allclose(made.origin.interpolate(self.vertices), made.vertices, atol=1e-12)
        np.testing.assert_array_equal(made.vertices[:len(self.vertices)], self.vertices)
        chain = made.chains[0]
        self.assertEqual((chain.closed, chain.length), (False, len(self.curve)))
        np.testing.assert_array_equal(chain.places, np.arange(chain.length))
        np.testing.assert_allclose(made.vertices[chain.vertices], self.curve.positions, atol=1e-12)
        edges = {tuple(sorted(e)) for face in made.faces.tolist() for e in zip(face, face[1:] + face[:1])}
        for a, b in zip(chain.vertices[:-1], chain.vertices[1:]):
            self.assertIn(tuple(sorted((a, b))), edges)
        old, new = (area(m.vertices, m.faces) for m in (self.mesh, made))
        summed = np.bincount(made.origin.faces, new, len(old))
        np.testing.assert_allclose(summed, old, rtol=1e-9)  # no face is lost or enlarged

    def test_attributes(self):
        made = self.mesh.cut(self.curve, carry={"id": "nearest"}).mesh
        at, origin = made.vertex_attributes, made.origin
        np.testing.assert_allclose(at["linear"], linear(made.vertices), atol=1e-9)
        nearest = origin.vertices[np.arange(len(made.vertices)), origin.weights.argmax(axis=1)]
        ties = np.sort(origin.weights, axis=1)
        clear = ties[:, 2] - ties[:, 1] > 1e-9
        np.testing.assert_array_equal(at["id"][clear], nearest[clear])
        np.testing.assert_array_equal(at["old_label"], at["id"] + 0.5)
        np.testing.assert_allclose(at["wide"], np.tile(made.vertices, 40), rtol=1e-5, atol=1e-5)
        expected = origin.interpolate(self.mesh.vertex_attributes["colour"])
        self.assertLessEqual(np.abs(at["colour"] - expected).max(), 0.5 + 1e-9)
        np.testing.assert_allclose(np.linalg.norm(at["normal"], axis=1), 1)
        np.testing.assert_allclose(at["tensor"], np.tile(np.eye(2), (len(made.vertices), 1, 1)))
        np.testing.assert_array_equal(made.face_attributes["number"], origin.faces)
        np.testing.assert_array_equal(made.face_attributes["even"], origin.faces % 2 == 0)
        corners = linear(made.vertices[made.faces])
        for name, values in (("uv", corners), ("four", corners[..., [0, 1, 0, 1]]),
                             ("one", corners[..., 0])):
            np.testing.assert_allclose(made.corner_attributes[name], values, atol=1e-9)
        self.assertTrue((made.corner_attributes["byte"] == 7).all())
        for ours, theirs in ((at, self.mesh.vertex_attributes),
                             (made.face_attributes, self.mesh.face_attributes),
                             (made.corner_attributes, self.mesh.corner_attributes)):
            self.assertEqual({name: (a.dtype, a.shape[1:]) for name, a in ours.items()},
                             {name: (a.dtype, a.shape[1:]) for name, a in theirs.items()})

    def test_pieces_and_lids(self):
        vertices, faces = support.torus()
        mesh = talweg.Mesh(vertices, faces, vertex_attributes={"color": np.zeros((len(vertices), 3))},
                           corner_attributes={"uv": np.zeros((len(faces), 3, 2))})
        rings = [talweg.Curve(vertices=i * 60 + np.arange(60), closed=True) for i in (10, 40)]
        pieces = mesh.cut(rings, split=True, cap="planar").meshes
        self.assertEqual(len(pieces), 2)
        for piece in pieces:
            lid = piece.origin.faces < 0
            self.assertTrue(lid.any())
            self.assertTrue(np.isnan(piece.corner_attributes["uv"][lid]).all())
            self.assertFalse(np.isnan(piece.corner_attributes["uv"][~lid]).any())
            self.assertEqual(talweg.inspect(piece)["boundary_edges"], 0)
            self.assertEqual([chain.length for chain in piece.chains], [60, 60])
        whole = mesh.cut(rings, open=True)
        self.assertEqual(talweg.inspect(whole.mesh)["boundary_loops"], 4)
        with self.assertRaisesRegex(talweg.BadUsage, "2 meshes"):
            mesh.cut(rings, split=True).mesh  # pylint: disable=expression-not-assigned

    def test_arguments(self):
        bare = talweg.cut((self.vertices, self.faces), self.curve).mesh
        self.assertEqual(bare.vertex_attributes, {})
        np.testing.assert_array_equal(bare.faces, self.mesh.cut(self.curve).mesh.faces)
        for wrong, error, sentence in (
                ({"carry": {"idd": "linear"}}, talweg.BadUsage, "no such attribute"),
                ({"carry": {"id": "maybe"}}, talweg.BadUsage, "must be one of linear"),
                ({"keep": "top"}, talweg.BadUsage, "keep"), ({"opne": True}, talweg.BadUsage, "open")):
            with self.assertRaisesRegex(error, sentence):
                self.mesh.cut(self.curve, **wrong)
        with self.assertRaisesRegex(talweg.BadCurve, "99999999"):
            self.mesh.cut([5, 99999999])
        high = talweg.Mesh(self.vertices, self.faces,
                           vertex_attributes={"id": np.full(len(self.vertices), 2**60)})
        with self.assertRaisesRegex(talweg.BadUsage, "2\\^53"):
            high.cut(self.curve)

    def test_pickle(self):
        made = self.mesh.cut(self.curve)
        again = pickle.loads(pickle.dumps(made))
        np.testing.assert_array_equal(again.mesh.faces, made.mesh.faces)
        np.testing.assert_array_equal(again.mesh.origin.weights, made.mesh.origin.weights)
        self.assertEqual(again.report, made.report)
        self.assertGreater(again.mesh.smooth(again.mesh.draw([0, 61])).report.length_after, 0)

    def test_same_as_the_driver(self):
        with tempfile.TemporaryDirectory() as folder:
            support.write_obj(Path(folder) / "a.obj", self.vertices, self.faces)
            talweg.write_curves(Path(folder) / "a.json", self.curve)
            support.driver(folder, "cut", "a.obj", "--curve", "a.json", "-o", "b.ply")
            vertices, faces = support.read_ply(Path(folder) / "b.ply")
        made = self.mesh.cut(self.curve).mesh
        np.testing.assert_array_equal(made.vertices.astype(vertices.dtype), vertices)
        np.testing.assert_array_equal(made.faces, faces)


def area(vertices, faces):
    a, b, c = np.moveaxis(vertices[faces], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


if __name__ == "__main__":
    unittest.main()
