"""Mesh files: read with all their data, written with the driver's bytes."""

import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg

OBJ = """mtllib bone.mtl
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0 0 0 1
v 0 1 0 1 1 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vt 0.5 0.5
g left side
usemtl ivory
f 1/1 2/2 3/3
usemtl caf\xe9
f 1/5 3/3 4/4
"""


class MeshFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def path(self, name):
        return self.folder / name

    def written(self, name, text, encoding="latin-1"):
        self.path(name).write_bytes(text.encode(encoding))
        return self.path(name)

    def test_ply_with_attributes(self):
        path = self.written("a.ply", """ply
format ascii 1.0
element vertex 4
property double x
property double y
property double z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property float quality
property float s
property float t
property short level_0
property short level_1
element face 1
property list uchar int vertex_indices
property int label
end_header
0 0 0 0 0 1 255 0 0 0.5 0 0 1 2
1 0 0 0 0 1 0 255 0 1.5 1 0 3 4
1 1 0 0 0 1 0 0 255 2.5 1 1 5 6
0 1 0 0 0 1 9 9 9 3.5 0 1 7 8
4 0 1 2 3 7
""")
        with self.assertLogs("talweg", "INFO") as told:
            mesh = talweg.read_mesh(path)
        self.assertEqual(told.output, [
            f"INFO:talweg:{path}: 1 faces of more than three corners became triangles."])
        np.testing.assert_array_equal(mesh.faces, [[0, 1, 2], [0, 2, 3]])
        self.assertEqual(mesh.vertices.dtype, np.float64)
        expected = {"normals": ("f4", [[0, 0, 1]] * 4),
                    "colors": ("u1", [[255, 0, 0], [0, 255, 0], [0, 0, 255], [9, 9, 9]]),
                    "quality": ("f4", [0.5, 1.5, 2.5, 3.5]),
                    "uv": ("f4", [[0, 0], [1, 0], [1, 1], [0, 1]]),
                    "level": ("i2", [[1, 2], [3, 4], [5, 6], [7, 8]])}
        self.assertEqual(list(mesh.vertex_attributes), list(expected))
        for name, (kind, values) in expected.items():
            self.assertEqual(mesh.vertex_attributes[name].dtype, np.dtype(kind), name)
            np.testing.assert_array_equal(mesh.vertex_attributes[name], values)
        np.testing.assert_array_equal(mesh.face_attributes["label"], [7, 7])
        talweg.write_mesh(self.path("b.ply"), mesh)
        self.assertIn(b"property short level_1\n", self.path("b.ply").read_bytes())
        self.same(talweg.read_mesh(self.path("b.ply")), mesh)

    def same(self, mesh, other):
        np.testing.assert_array_equal(mesh.vertices, other.vertices)
        np.testing.assert_array_equal(mesh.faces, other.faces)
        for element in ("vertex", "face", "corner"):
            ours, theirs = (getattr(m, element + "_attributes") for m in (mesh, other))
            self.assertEqual(list(ours), list(theirs))
            for name, values in ours.items():
                self.assertEqual(values.dtype, theirs[name].dtype, name)
                np.testing.assert_array_equal(values, theirs[name])
        self.assertEqual(mesh.face_names, other.face_names)
        self.assertEqual(mesh.references, other.references)

    def test_obj_with_groups_and_texture(self):
        mesh = talweg.read_mesh(self.written("a.obj", OBJ))
        np.testing.assert_array_equal(
            mesh.corner_attributes["uv"],
            [[[0, 0], [1, 0], [1, 1]], [[0.5, 0.5], [1, 1], [0, 1]]])
        material = mesh.face_names["usemtl"]
        self.assertEqual([material[k] for k in mesh.face_attributes["usemtl"]],
                         ["ivory", "caf\udce9"])  # with any bytes of the file
        self.assertEqual(mesh.face_names["g"][mesh.face_attributes["g"][1]], "left side")
        self.assertEqual(mesh.references, ["mtllib bone.mtl"])
        talweg.write_mesh(self.path("b.obj"), mesh)
        self.same(talweg.read_mesh(self.path("b.obj")), mesh)
        self.assertEqual(self.path("b.obj").read_bytes().count(b"\nvt "), 5)  # entries are shared again
        self.same(pickle.loads(pickle.dumps(mesh)), mesh)

    def test_pieces_keep_names(self):
        mesh = talweg.read_mesh(self.written("a.obj", OBJ))
        cut = talweg.cut(mesh, talweg.Curve(positions=[[0.2, 0, 0], [0.8, 1, 0]]), split=True)
        self.assertEqual(len(cut.meshes), 2)
        for k, piece in enumerate(cut.meshes):
            talweg.write_mesh(self.path(f"{k}.obj"), piece)
            back = talweg.read_mesh(self.path(f"{k}.obj"))
            names = back.face_names["usemtl"]
            self.assertEqual({names[n] for n in back.face_attributes["usemtl"]},
                             {"ivory", "caf\udce9"})
            self.assertEqual(back.references, mesh.references)

    def test_attributes_that_a_format_does_not_hold_are_reported(self):
        mesh = talweg.read_mesh(self.written("a.obj", OBJ))
        mesh.vertex_attributes["heat"] = np.arange(4.0)
        mesh.corner_attributes["weight"] = np.ones((2, 3, 1))
        with self.assertLogs("talweg", "WARNING") as told:
            talweg.write_mesh(self.path("b.obj"), mesh)
        self.assertEqual(told.output, [f"WARNING:talweg:{self.path('b.obj')} does not hold: 'weight'"
                                       " of corners, 'heat' of vertices."])
        with self.assertLogs("talweg", "WARNING") as told:
            talweg.write_mesh(self.path("b.ply"), mesh)
        self.assertRegex(told.output[0], r"names of faces \(g\), names of faces \(usemtl\)")
        back = talweg.read_mesh(self.path("b.ply"))  # the numbers are there
        np.testing.assert_array_equal(back.face_attributes["usemtl"], [1, 2])
        np.testing.assert_array_equal(back.vertex_attributes["heat"], mesh.vertex_attributes["heat"])

    def test_names_that_files_cannot_have(self):
        vertices, faces = support.hills()
        n = len(vertices)
        mesh = talweg.Mesh(vertices, faces, vertex_attributes={
            "x": np.arange(n), "my value": np.arange(n) * 2, "my_value": np.arange(n) * 3})
        talweg.write_mesh(self.path("a.ply"), mesh)
        back = talweg.read_mesh(self.path("a.ply"))
        self.assertEqual(list(back.vertex_attributes), ["x_", "my_value", "my_value_"])
        np.testing.assert_array_equal(back.vertex_attributes["my_value_"], np.arange(n) * 3)
        np.testing.assert_array_equal(back.vertices, vertices)

    def test_same_bytes_as_the_driver(self):
        vertices, faces = support.hills()
        mesh = talweg.Mesh(vertices, faces,
                           vertex_attributes={"height": vertices[:, 2].astype(np.float32)},
                           face_attributes={"label": np.arange(len(faces), dtype=np.int32) % 5})
        drawn = talweg.draw((vertices, faces), support.staircase())
        talweg.write_mesh(self.path("in.ply"), mesh)
        talweg.write_curves(self.path("in.json"), drawn)
        for more, how in ((["--open"], {"open": True}), ([], {})):
            support.driver(self.folder, "cut", "in.ply", "--curve", "in.json", "-o", "theirs.ply",
                           "--tag", *more)
            ours = talweg.cut(self.path("in.ply"), talweg.read_curves(self.path("in.json")), **how)
            talweg.write_mesh(self.path("ours.ply"), ours.mesh, tag=True)
            self.assertEqual(self.path("ours.ply").read_bytes(),
                             self.path("theirs.ply").read_bytes())

    def test_everything_takes_files(self):
        vertices, faces = support.hills()
        turned = faces.copy()
        turned[0] = turned[0][::-1]
        talweg.write_mesh(self.path("a.off"), (vertices, turned))
        self.assertEqual(talweg.inspect(self.path("a.off"))["verdict"], "repairable")
        with self.assertRaisesRegex(talweg.BadMesh, r"a\.off: .*opposite orientation"):
            talweg.read_mesh(self.path("a.off"))
        self.assertEqual(len(talweg.repair(str(self.path("a.off"))).mesh.faces), len(faces))
        mesh = talweg.read_mesh(self.path("a.off"), repair="orient")
        self.assertEqual(mesh.repair_steps, "orient")

    def test_bad_input(self):
        vertices, faces = support.hills()
        with self.assertRaisesRegex(talweg.BadFile, "none.ply: No such file"):
            talweg.read_mesh(self.path("none.ply"))
        with self.assertRaisesRegex(talweg.BadFile, "bad.obj, line 2: "):
            talweg.read_mesh(self.written("bad.obj", "v 0 0 0\nv 1 zero 0\n"))
        with self.assertRaisesRegex(talweg.BadFile, r"'\.vtu' is not a mesh format"):
            talweg.Mesh(self.path("a.vtu"))
        with self.assertRaisesRegex(talweg.BadFile, "does not end in"):
            talweg.write_mesh(self.path("a.vtu"), (vertices, faces))
        with self.assertRaisesRegex(talweg.BadMesh, "vertex 99999"):
            talweg.write_mesh(self.path("a.ply"), (vertices, [[0, 1, 99999]]))
        with self.assertRaisesRegex(talweg.BadUsage, "tag needs a mesh that was cut"):
            talweg.write_mesh(self.path("a.ply"), (vertices, faces), tag=True)
        mesh = talweg.Mesh(vertices, faces, face_attributes={"usemtl": np.full(len(faces), 2)})
        mesh.face_names["usemtl"] = ["", "one"]
        with self.assertRaisesRegex(talweg.BadUsage, '"usemtl" has the value 2, but only 2 names'):
            talweg.write_mesh(self.path("a.obj"), mesh)
        mesh.face_names = {"g": ["a\nb"]}
        with self.assertRaisesRegex(talweg.BadUsage, 'names for the attribute "g"'):
            talweg.write_mesh(self.path("a.obj"), mesh)
        mesh.face_names = {"usemtl": ["", "one", "two\nlines"]}
        with self.assertRaisesRegex(talweg.BadUsage, "more than one line"):
            talweg.write_mesh(self.path("a.obj"), mesh)
        mesh.face_attributes["label"] = np.zeros(3)
        with self.assertRaisesRegex(talweg.BadUsage, "label must have the shape"):
            talweg.write_mesh(self.path("a.ply"), mesh)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["bad.obj"])


if __name__ == "__main__":
    unittest.main()
