"""Attributes of meshes: kept, checked, and unchanged after a conversion to each other package and back."""

import importlib
import types
import unittest

import numpy as np

import support
import talweg


def package(test, name, how):
    """Imports the package; skips the test if it is missing."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return test.skipTest(f"no {name} ({how})")


class Attributes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills(20)
        n, m = len(cls.vertices), len(cls.faces)
        random = np.random.RandomState(1)
        cls.given = {
            "vertex_attributes": {"normal": random.rand(n, 3), "label": random.randint(0, 9, n),
                                  "weight": random.rand(n).astype(np.float32)},
            "face_attributes": {"material": random.randint(0, 4, m).astype(np.int32)},
            "corner_attributes": {"texture": random.rand(m, 3, 2), "crease": random.rand(m, 3)}}

    def mesh(self):
        return talweg.Mesh(self.vertices, self.faces, **self.given)

    def same(self, mesh, but=()):
        np.testing.assert_array_equal(mesh.vertices, self.vertices)
        np.testing.assert_array_equal(mesh.faces, self.faces)
        for where, expected in self.given.items():
            kept = {} if where in but else expected
            self.assertEqual(set(getattr(mesh, where)), set(kept), where)
            for name, values in kept.items():
                found = getattr(mesh, where)[name]
                self.assertEqual((found.shape, found.dtype), (values.shape, values.dtype), name)
                np.testing.assert_array_equal(found, values, name)

    def test_kept_without_a_copy(self):
        mesh = self.mesh()
        self.same(mesh)
        self.assertTrue(np.shares_memory(mesh.corner_attributes["texture"],
                                         self.given["corner_attributes"]["texture"]))
        self.same(talweg.Mesh(mesh))
        again = talweg.Mesh(mesh, vertex_attributes={"label": np.zeros(len(self.vertices))})
        self.assertEqual(again.vertex_attributes["label"].max(), 0)
        self.assertEqual(set(again.vertex_attributes), set(mesh.vertex_attributes))

    def test_refused(self):
        n, m = len(self.vertices), len(self.faces)
        for where, values, why in (
                ("vertex_attributes", {"a": np.zeros(n + 1)}, rf"vertex attribute a .*\({n}, \.\.\.\)"),
                ("vertex_attributes", {"a": 1.0}, r"vertex attribute a .* not \(\)"),
                ("face_attributes", {"a": np.zeros(n)}, rf"face attribute a .*\({m}, \.\.\.\)"),
                ("face_attributes", {"a": ["x"] * m}, "face attribute a must hold numbers"),
                ("face_attributes", {"a": [[1], [1, 2]]}, "not equally long"),
                ("corner_attributes", {"a": np.zeros((m, 2))}, rf"corner .*\({m}, 3, \.\.\.\)"),
                ("corner_attributes", {1: np.zeros((m, 3))}, "name of a corner attribute .* not 1")):
            with self.subTest(where=where, why=why), self.assertRaisesRegex(talweg.BadUsage, why):
                talweg.Mesh(self.vertices, self.faces, **{where: values})

    def test_changed_attributes_are_checked_before_output(self):
        package(self, "meshio", "Debian: python3-meshio")
        mesh = self.mesh()
        mesh.face_attributes["late"] = [1, 2, 3]
        with self.assertRaisesRegex(talweg.BadUsage, "face attribute late"):
            mesh.to_meshio()

    def test_meshio(self):
        package(self, "meshio", "Debian: python3-meshio")
        with self.assertLogs("talweg", "WARNING") as log:
            out = self.mesh().to_meshio()
        self.assertIn("texture, crease left out", log.output[0])
        self.same(talweg.Mesh(out), but=["corner_attributes"])

    def test_polygons_of_meshio_keep_their_attributes(self):
        quads, triangles = self.faces_of_quads()
        n = len(quads) // 2
        blocks = [types.SimpleNamespace(type="vertex", data=np.array([[0]])),
                  types.SimpleNamespace(type="quad", data=quads[:n]),
                  types.SimpleNamespace(type="triangle", data=triangles[2 * n:])]
        numbers = np.arange(len(quads))
        mesh = talweg.Mesh(types.SimpleNamespace(
            points=self.vertices, cells=blocks, point_data={"x": self.vertices[:, 0]},
            cell_data={"n": [[-1], numbers[:n], np.repeat(numbers[n:], 2)]}))
        np.testing.assert_array_equal(mesh.faces, triangles)
        np.testing.assert_array_equal(mesh.face_attributes["n"], np.repeat(numbers, 2))
        np.testing.assert_array_equal(mesh.vertex_attributes["x"], self.vertices[:, 0])

    def faces_of_quads(self):
        a = np.arange(400).reshape(20, 20)[:-1, :-1].ravel()
        quads = np.stack([a, a + 20, a + 21, a + 1], -1)
        return quads, quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)

    def test_vtk(self):
        package(self, "vtkmodules.util.numpy_support", "Debian: python3-vtk9")
        self.same(talweg.Mesh(self.mesh().to_vtk()))

    def test_vtk_polygons(self):
        support_ = package(self, "vtkmodules.util.numpy_support", "Debian: python3-vtk9")
        core = importlib.import_module("vtkmodules.vtkCommonCore")
        model = importlib.import_module("vtkmodules.vtkCommonDataModel")
        quads, triangles = self.faces_of_quads()
        points = core.vtkPoints()
        points.SetData(support_.numpy_to_vtk(self.vertices))
        polydata, polygons, lines = model.vtkPolyData(), model.vtkCellArray(), model.vtkCellArray()
        polydata.SetPoints(points)
        lines.InsertNextCell(2, [0, 1])
        for quad in quads[:-1].tolist():
            polygons.InsertNextCell(4, quad)
        for triangle in triangles[-2:].tolist():
            polygons.InsertNextCell(3, triangle)
        polydata.SetPolys(polygons)
        polydata.SetLines(lines)
        number = support_.numpy_to_vtk(np.arange(1 + len(quads) + 1))  # the first value belongs to the line
        number.SetName("n")
        polydata.GetCellData().AddArray(number)
        texts = core.vtkStringArray()
        texts.SetName("texts")
        texts.SetNumberOfValues(len(self.vertices))
        polydata.GetPointData().AddArray(texts)
        mesh = talweg.Mesh(polydata)
        np.testing.assert_array_equal(mesh.faces, triangles)
        np.testing.assert_array_equal(
            mesh.face_attributes["n"],
            np.r_[np.repeat(np.arange(1, len(quads)), 2), len(quads), len(quads) + 1])
        self.assertEqual(mesh.vertex_attributes, {})
        for other, why in ((model.vtkPolyData(), "no triangles"),
                           (model.vtkUnstructuredGrid(), "not vtkUnstructuredGrid")):
            with self.assertRaisesRegex(talweg.BadMesh, why):
                talweg.Mesh(other)
        polydata.SetStrips(polygons)
        with self.assertRaisesRegex(talweg.BadMesh, "vtkTriangleFilter"):
            talweg.Mesh(polydata)

    def test_pyvista(self):
        package(self, "pyvista", "pip install pyvista")
        self.same(talweg.Mesh(self.mesh().to_pyvista()))

    def test_vedo(self):
        vedo = package(self, "vedo", "Debian: python3-vedo")
        mesh = talweg.Mesh(vedo.Mesh(self.mesh().to_vtk()))
        np.testing.assert_array_equal(mesh.faces, self.faces)
        np.testing.assert_array_equal(mesh.face_attributes["material"],
                                      self.given["face_attributes"]["material"])

    def test_trimesh(self):
        package(self, "trimesh", "pip install trimesh")
        self.same(talweg.Mesh(self.mesh().to_trimesh()))

    def test_colours_and_texture_of_trimesh(self):
        package(self, "trimesh", "pip install trimesh")
        n, m = len(self.vertices), len(self.faces)
        random = np.random.RandomState(2)
        for where, name, values, kind in (
                ("vertex_attributes", "colors", random.randint(0, 255, (n, 4)), "vertex"),
                ("face_attributes", "colors", random.randint(0, 255, (m, 4)), "face"),
                ("vertex_attributes", "uv", random.rand(n, 2), "texture")):
            values = values.astype(np.uint8) if name == "colors" else values
            out = talweg.Mesh(self.vertices, self.faces, **{where: {name: values}}).to_trimesh()
            self.assertEqual(out.visual.kind, kind)
            np.testing.assert_array_equal(getattr(talweg.Mesh(out), where)[name], values)


if __name__ == "__main__":
    unittest.main()
