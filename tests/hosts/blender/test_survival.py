"""Data of a mesh that cutting must keep, or report as lost: shape keys, layers, custom normals; linked
meshes."""

import tempfile
from pathlib import Path

import bmesh
import bpy
import numpy as np
from talweg_blender import attributes, cutting, drawings, jobs

import scene
import test_pieces


class Survival(test_pieces.Dressed):
    def test_a_linked_mesh_is_refused(self):
        path = str(Path(tempfile.mkdtemp()) / "library.blend")
        bpy.data.libraries.write(path, {self.obj.data}, fake_user=True)
        with bpy.data.libraries.load(path, link=True) as (there, here):
            here.meshes = there.meshes
        self.obj.data = here.meshes[0]
        self.assertIsNotNone(self.obj.data.library)
        self.refused("linked from a library", bpy.ops.talweg.repair)

    def add_shape_keys(self):
        self.obj.shape_key_add(name="Basis")
        key = self.obj.shape_key_add(name="Label")
        key.value = 0.25
        key.data.foreach_set("co", self.keyed(scene.vertices_of(self.obj)).astype(np.float32).ravel())

    def keyed(self, xyz):
        return xyz * [2, 1, 1] + [0, 0, 5]

    def check_shape_keys(self, obj):
        keys = obj.data.shape_keys.key_blocks
        self.assertEqual(keys.keys(), ["Basis", "Label"])
        self.assertEqual(keys["Label"].value, 0.25)
        xyz = scene.vertices_of(obj)
        np.testing.assert_allclose(attributes.read(keys["Basis"].data, "co", 3), xyz, atol=1e-5)
        np.testing.assert_allclose(attributes.read(keys["Label"].data, "co", 3), self.keyed(xyz), atol=1e-4)

    def test_shape_keys_survive(self):
        self.add_shape_keys()
        test_pieces.across()
        self.assertEqual(bpy.ops.talweg.cut(), {"FINISHED"})
        self.check(self.obj)
        self.check_shape_keys(self.obj)
        self.assertEqual(bpy.ops.talweg.material_borders(), {"FINISHED"})
        self.check_shape_keys(self.obj)
        self.assertEqual(bpy.ops.talweg.separate(cap="least-area"), {"FINISHED"})
        for piece in (o for o in bpy.data.objects if o.type == "MESH"):
            self.check_shape_keys(piece)

    def test_layers_survive(self):
        """Bevel weights, creases and masks of vertices, face maps, pins, marks, hidden elements."""
        mesh = self.obj.data
        bm = bmesh.new()
        bm.from_mesh(mesh)
        for layer in (bm.verts.layers.crease, bm.verts.layers.paint_mask, bm.verts.layers.skin):
            layer.verify()
        bm.to_mesh(mesh)
        bm.free()
        x = scene.vertices_of(self.obj)[:, 0]
        attributes.write(mesh.vertex_creases[0].data, "value", x / 60)
        attributes.write(mesh.vertex_paint_masks[0].data, "value", x / 60)
        attributes.write(mesh.skin_vertices[0].data, "radius", np.stack([x, x], -1))
        attributes.write(mesh.vertices, "bevel_weight", (x / 60).astype(np.float32))
        left = attributes.read(mesh.polygons, "center", 3)[:, 0] < 20
        self.obj.face_maps.new(name="Left")
        attributes.write(mesh.face_maps.new().data, "value", np.where(left, 0, -1).astype(np.int32))
        attributes.write(mesh.polygons, "use_freestyle_mark", left)
        attributes.write(mesh.polygons, "hide", left)
        attributes.write(mesh.uv_layers[0].data, "pin_uv", np.ones(len(mesh.loops), bool))
        test_pieces.across()
        self.assertEqual(bpy.ops.talweg.cut(), {"FINISHED"})
        x = scene.vertices_of(self.obj)[:, 0]
        for values, accuracy in ((attributes.read(mesh.vertex_creases[0].data, "value"), 1e-5),
                                 (attributes.read(mesh.vertex_paint_masks[0].data, "value"), 1e-5),
                                 (attributes.read(mesh.vertices, "bevel_weight"), 0.01),
                                 (attributes.read(mesh.skin_vertices[0].data, "radius", 2)[:, 0] / 60, 1e-5)):
            np.testing.assert_allclose(values, x / 60, atol=accuracy)
        left = attributes.read(mesh.polygons, "center", 3)[:, 0] < 20
        self.assertEqual(self.obj.face_maps.keys(), ["Left"])
        np.testing.assert_array_equal(attributes.read(mesh.face_maps[0].data, "value", 1, np.int32), left - 1)
        for name in ("use_freestyle_mark", "hide"):
            np.testing.assert_array_equal(attributes.read(mesh.polygons, name, 1, bool), left, name)
        self.assertTrue(attributes.read(mesh.uv_layers[0].data, "pin_uv", 1, bool).all())

    def test_custom_normals_survive(self):
        mesh = self.obj.data
        mesh.use_auto_smooth = True
        attributes.write(mesh.polygons, "use_smooth", np.ones(len(mesh.polygons), bool))
        mesh.normals_split_custom_set(tilted(mesh).tolist())
        test_pieces.across()
        sharp = attributes.read(mesh.edges, "use_edge_sharp", 1, bool).sum()
        self.assertEqual(bpy.ops.talweg.cut(), {"FINISHED"})
        self.assertTrue(mesh.has_custom_normals)
        mesh.calc_normals_split()
        normals = attributes.read(mesh.loops, "normal", 3)
        np.testing.assert_allclose(normals, tilted(mesh), atol=0.01)
        self.assertLess(attributes.read(mesh.edges, "use_edge_sharp", 1, bool).sum(), sharp + 5)

    def test_lost_attributes_are_reported(self):
        self.obj.data.attributes.new("Note", "STRING", "POINT")
        arrays = drawings.MeshArrays(self.obj.data)
        self.assertEqual(jobs.now(cutting.repair(self.obj, arrays, "drop"))[1],
                         ["The changed mesh could not keep the string attribute Note; Ctrl Z brings it back."])


def tilted(mesh):
    """A direction for each corner that depends only on its place."""
    xyz = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.vertices.foreach_get("co", xyz.ravel())
    at = xyz[attributes.read(mesh.loops, "vertex_index", 1, np.int32)]
    result = np.stack([0.3 + 0.005 * at[:, 0], 0.2 - 0.003 * at[:, 1], np.ones(len(at))], -1)
    return result / np.linalg.norm(result, axis=1, keepdims=True)
