"""talweg.labels, measure, inspect, repair, and Mesh(..., repair=...)."""

import json
import os
import pickle
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg


def quarters(points):
    return (points[..., 0] > 30).astype(int) * 10 + (points[..., 1] > 25)


def broken():
    """hills() with separate vertices for each face, and one face twice."""
    vertices, faces = support.hills()
    soup = np.arange(3 * len(faces)).reshape(-1, 3)
    return vertices[faces].reshape(-1, 3), np.concatenate([soup, soup[:1]])


def rid_of_times(tree):
    return {name: value for name, value in tree.items() if name not in ("time_ms", "version")}


class Labels(unittest.TestCase):
    def setUp(self):
        self.vertices, self.faces = support.hills()
        self.labels = quarters(self.vertices[self.faces].mean(axis=1))
        self.mesh = talweg.Mesh(self.vertices, self.faces, face_attributes={"part": self.labels},
                                vertex_attributes={"height": self.vertices[:, 2]})

    def test_faces(self):
        found = self.mesh.labels("part")
        self.assertEqual(len(found.borders), 4)
        sides = {tuple(sorted(pair)) for pair in zip(found.left.tolist(), found.right.tolist())}
        self.assertEqual(sides, {(0, 1), (0, 10), (1, 11), (10, 11)})
        self.assertEqual(set(found.labels.tolist()), {0, 1, 10, 11})
        self.assertGreater((found.labels == self.labels).mean(), 0.95)
        made = found.mesh
        np.testing.assert_allclose(made.vertex_attributes["height"], made.vertices[:, 2], atol=1e-9)
        np.testing.assert_array_equal(made.face_attributes["part"], self.labels[made.origin.faces])
        exact = made.face_attributes["label"]
        ab = np.moveaxis(made.vertices[made.faces], 1, 0)
        areas = np.linalg.norm(np.cross(ab[1] - ab[0], ab[2] - ab[0]), axis=1)
        for face in np.unique(made.origin.faces[exact != self.labels[made.origin.faces]])[:50]:
            parts = made.origin.faces == face  # the new label is that of the larger part
            shares = {label: areas[parts & (exact == label)].sum() for label in set(exact[parts])}
            self.assertGreaterEqual(shares[found.labels[face]] * (1 + 1e-9), max(shares.values()))
        for number, chain in enumerate(made.chains):
            np.testing.assert_allclose(made.vertices[chain.vertices],
                                       found.borders[number].positions, atol=1e-9)
        self.assertEqual(len(found.reports), 4)
        self.assertEqual(len(found.report["regions"]), 4)
        again = pickle.loads(pickle.dumps(found))
        np.testing.assert_array_equal(again.labels, found.labels)

    def test_as_the_driver(self):
        with tempfile.TemporaryDirectory() as folder:
            support.write_obj(Path(folder) / "a.obj", self.vertices, self.faces)
            (Path(folder) / "l.txt").write_text("\n".join(map(str, self.labels)))
            support.driver(folder, "labels", "a.obj", "l.txt", "--tau", "2", "--report", "r.json",
                           "-o", "b.json", "--labels-out", "n.txt")
            new = np.loadtxt(Path(folder) / "n.txt", dtype=int)
            told = json.loads((Path(folder) / "r.json").read_text())
            borders = support.driver_curves(Path(folder) / "b.json")
        found = self.mesh.labels("part", tau=2)
        np.testing.assert_array_equal(found.labels, new)
        ours, theirs = rid_of_times(found.report), rid_of_times(told)
        for report in (ours, theirs):
            report.pop("peak_memory_mib")
        self.assertEqual([report.length_after for report in found.reports],
                         [curve["length_after"] for curve in theirs.pop("curves")])
        self.assertEqual(ours, theirs)
        for (_, faces, barycentrics, _), border in zip(borders, found.borders):
            np.testing.assert_array_equal(faces, border.faces)
            np.testing.assert_array_equal(barycentrics, border.barycentrics)

    def test_vertices(self):
        halves = (self.vertices[:, 0] > 30).astype(int)
        found = talweg.labels(self.mesh, halves, tau=2, cut_mesh=False)
        self.assertEqual((found.left.tolist(), found.right.tolist()), ([0], [1]))
        self.assertLess(np.abs(found.borders[0].positions[:, 0] - 30.5).max(), 2)
        self.assertEqual(len(found.labels), len(self.faces))
        self.assertIsNone(found.mesh)

    def test_bad(self):
        for values, sentence in (([1, 2], "has 2 values, but the mesh has 6962 triangles"),
                                 (self.labels + 0.5, "must be whole numbers"),
                                 ("parts", "no attribute parts")):
            with self.assertRaisesRegex(talweg.BadUsage, sentence):
                self.mesh.labels(values)
        with self.assertRaisesRegex(talweg.BadUsage, "faces or vertices"):
            self.mesh.labels("part", of="edges")


class Measure(unittest.TestCase):
    def test_as_the_driver(self):
        vertices, faces = support.hills()
        mesh = talweg.Mesh(vertices, faces)
        drawn = mesh.draw(support.staircase()[::9], exact=False)
        smooth = mesh.smooth(drawn, 2).curve
        with tempfile.TemporaryDirectory() as folder:
            support.write_obj(Path(folder) / "a.obj", vertices, faces)
            talweg.write_curves(Path(folder) / "s.json", smooth)
            talweg.write_curves(Path(folder) / "d.json", drawn)
            support.driver(folder, "measure", "a.obj", "s.json", "d.json", "--edge", "1.5", "--report",
                           "r.json")
            told = json.loads((Path(folder) / "r.json").read_text())
            smooth, drawn = (talweg.read_curves(Path(folder) / name)[0] for name in ("s.json", "d.json"))
        found = mesh.measure(smooth, drawn, edge=1.5)
        self.assertEqual(rid_of_times(found.total), rid_of_times(told))
        self.assertEqual(found.curves[0]["length"], found.total["length"])
        alone = talweg.measure((vertices, faces), smooth)
        self.assertNotIn("other", alone.total)
        self.assertEqual(pickle.loads(pickle.dumps(alone)), alone)
        with self.assertRaisesRegex(talweg.BadUsage, "Edge"):
            mesh.measure(smooth, edge=-1)


class Repair(unittest.TestCase):
    def test_inspect_as_the_driver(self):
        vertices, faces = broken()
        with tempfile.TemporaryDirectory() as folder:
            support.write_obj(Path(folder) / "a.obj", vertices, faces)
            told = info(folder, "a.obj")
        found = talweg.inspect((vertices, faces))
        self.assertEqual(found["verdict"], "repairable")
        self.assertEqual(rid_of_times(found), rid_of_times(told))

    def test_repair(self):
        vertices, faces = broken()
        mesh = talweg.Mesh(vertices, faces, plugin="talweg.repair",
                           face_attributes={"number": np.arange(len(faces))},
                           corner_attributes={"uv": vertices[faces][..., :2]})
        fixed = talweg.repair(mesh)
        whole = support.hills()[0]
        self.assertEqual(len(np.unique(fixed.mesh.faces)), len(whole))
        self.assertEqual(len(fixed.mesh.vertices), len(vertices))  # numbers are kept
        np.testing.assert_allclose(fixed.mesh.vertices[fixed.became], vertices)
        np.testing.assert_array_equal(fixed.became_face, [*range(len(faces) - 1), 0])  # the last face repeats
                                                                                       # face 0
        np.testing.assert_array_equal(fixed.mesh.face_attributes["number"], np.arange(len(faces) - 1))
        np.testing.assert_array_equal(fixed.mesh.origin.faces, fixed.mesh.face_attributes["number"])
        np.testing.assert_allclose(fixed.mesh.corner_attributes["uv"],
                                   fixed.mesh.vertices[fixed.mesh.faces][..., :2])
        self.assertEqual(talweg.inspect(fixed.mesh)["verdict"], "usable")
        self.assertTrue(any("weld" in sentence for sentence in fixed.changes), fixed.changes)
        again = pickle.loads(pickle.dumps(fixed))
        np.testing.assert_array_equal(again.became, fixed.became)

    def test_bad(self):
        vertices, faces = broken()
        with self.assertRaises(talweg.BadMesh) as caught:
            talweg.repair((vertices, [[0, 1, 999999]]))
        self.assertIn("999999", str(caught.exception))
        for steps in ("weld,glue", "", 3):
            with self.assertRaisesRegex(talweg.BadUsage, "weld, drop, orient, split"):
                talweg.repair((vertices, faces), steps)
            with self.assertRaisesRegex(talweg.BadUsage, "weld, drop, orient, split"):
                talweg.Mesh(vertices, faces, repair=steps)
        with self.assertRaisesRegex(talweg.BadUsage, "one step"):
            talweg.repair((vertices, faces), False)

    def test_mesh_that_is_repaired(self):
        """Results have the indices of the given mesh, in every plugin."""
        vertices, faces = broken()
        with self.assertRaises(talweg.BadMesh):
            talweg.Mesh(vertices, faces)
        mesh = talweg.Mesh(vertices, faces, repair=True,
                           vertex_attributes={"x": vertices[:, 0]})
        first, last = faces[2000, 0], faces[5000, 1]
        drawn = mesh.draw([first, last])
        result = mesh.smooth(drawn, 2)
        curve = result.curve
        np.testing.assert_allclose(
            (vertices[faces[curve.faces]] * curve.barycentrics[:, :, None]).sum(axis=1),
            curve.positions, atol=1e-9)
        np.testing.assert_array_equal(vertices[first], curve.positions[0])
        self.assertTrue(any("Repair" in warning for warning in result.total.warnings))
        made = mesh.cut(curve).mesh
        np.testing.assert_allclose(made.origin.interpolate(vertices), made.vertices, atol=1e-9)
        np.testing.assert_allclose(made.vertex_attributes["x"], made.vertices[:, 0], atol=1e-9)
        labels = quarters(vertices[faces].mean(axis=1))
        self.assertEqual(len(mesh.labels(labels).labels), len(faces))
        self.assertGreater(mesh.measure(curve).total["length"], 0)
        self.assertEqual(len(mesh.distance(curve).distance), len(vertices))
        again = pickle.loads(pickle.dumps(mesh.workspace(drawn)))
        np.testing.assert_array_equal(again.smooth(2).curve.positions, curve.positions)
        with self.assertRaises(talweg.BadMesh):
            talweg.Mesh(vertices, faces, repair="orient")
        self.assertEqual(mesh.repair_steps, True)
        self.assertEqual(talweg.Mesh(vertices, faces, repair="drop, weld").repair_steps, "weld,drop")
        self.assertEqual(talweg.Mesh(vertices, faces, repair="drop, weld=1e-9").repair_steps,
                         "weld=1e-09,drop")
        with self.assertRaisesRegex(talweg.BadUsage, "length above 0"):
            talweg.Mesh(vertices, faces, repair="weld=0")

    def test_repair_welds_within_a_tolerance(self):
        gap = 1e-6  # two plates of 10 x 10; vertices 1 and 2 lie at 4 and 7, except for a gap
        vertices = np.array([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0], [10 + gap, 0, 0],
                             [20, 0, 0], [20, 10, 0], [10, 10 - gap, 0]])
        faces = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]
        told = talweg.inspect((vertices, faces))
        self.assertEqual(told["near_vertices"]["count"], 4)
        self.assertEqual(told["weld"]["steps"], "weld=1e-06")
        fixed = talweg.repair((vertices, faces), "weld=1e-6")
        self.assertEqual(fixed.became.tolist(), [0, 1, 2, 3, 1, 5, 6, 2])
        talweg.Mesh(vertices, faces, repair=told["weld"]["steps"]).draw([0, 6])  # the welded plates are one
                                                                                 # part


def info(folder, name):
    done = subprocess.run([os.environ["TALWEG_DRIVER"], "info", "--json", name], cwd=folder, text=True,
                          capture_output=True, check=False)
    return json.loads(done.stdout)


if __name__ == "__main__":
    unittest.main()
