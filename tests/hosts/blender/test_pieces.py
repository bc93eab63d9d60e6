"""Cuts, separation, borders of materials and vertex groups, and repair keep all data of a mesh."""

import unittest

import bpy
import numpy as np
from talweg_blender import attributes, jobs, last_report, objects, session
from talweg_blender.naming import named
from talweg_blender.package import talweg

import scene
import support

N = 60


def quads():
    a = np.arange(N * N).reshape(N, N)[:-1, :-1].ravel()
    return np.stack([a, a + N, a + N + 1, a + 1], -1)


def uv_of(points):
    return points[..., :2] / N


def dressed(obj):
    """Adds a UV map, a vertex group, colours, two materials, a seam, sharp edges, a crease and smooth
    faces."""
    mesh = obj.data
    xyz = scene.vertices_of(obj)
    at_loops = xyz[attributes.read(mesh.loops, "vertex_index", 1, np.int32)]
    attributes.write(mesh.uv_layers.new(name="Map").data, "uv", uv_of(at_loops))
    group = obj.vertex_groups.new(name="Right")
    for vertex in np.flatnonzero(xyz[:, 0] > 30.2).tolist():
        group.add([vertex], 1, "REPLACE")
    height = mesh.attributes.new("height", "FLOAT", "POINT")
    attributes.write(height.data, "value", xyz[:, 2])
    colour = mesh.color_attributes.new("Paint", "BYTE_COLOR", "CORNER")
    attributes.write(colour.data, "color_srgb",
                     np.concatenate([uv_of(at_loops), np.ones((len(at_loops), 2))], -1))
    for name in ("Below", "Above"):
        mesh.materials.append(bpy.data.materials.new(name))
    centres = attributes.read(mesh.polygons, "center", 3)
    attributes.write(mesh.polygons, "material_index", (centres[:, 1] > 30).astype(np.int32))
    attributes.write(mesh.polygons, "use_smooth", centres[:, 0] > 20)
    edges = xyz[attributes.read(mesh.edges, "vertices", 2, np.int32)]
    attributes.write(mesh.edges, "use_seam", (edges[..., 0] == 20).all(axis=1))
    attributes.write(mesh.edges, "use_edge_sharp", (edges[..., 1] == 40).all(axis=1))
    attributes.write(mesh.edges, "crease", (edges[..., 0] == 40).all(axis=1) * 0.5)
    mesh.update()


def curve_object(positions, closed=False, kind="POLY"):
    data = bpy.data.curves.new("Line", "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new(kind)
    spline.points.add(len(positions) - 1)
    spline.points.foreach_set("co", np.c_[positions, np.ones(len(positions))].ravel())
    spline.use_cyclic_u = closed
    obj = bpy.data.objects.new("Line", data)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    return obj


def hill(x, y):
    return 3 * np.sin(x / 7) * np.cos(y / 5)


def across(low=0.0, high=59.0):
    """A wave from side to side of the hills."""
    x = np.linspace(low, high, 120)
    y = 25.3 + 4 * np.sin(x / 6)
    return curve_object(np.stack([x, y, hill(x, y)], -1))


def textured():
    """The hills with a grid of colours."""
    obj = scene.add_mesh(support.hills()[0], quads())
    dressed(obj)
    image = bpy.data.images.new("Grid", 512, 512)
    image.generated_type = "COLOR_GRID"
    for material in obj.data.materials:
        material.use_nodes = True
        texture = material.node_tree.nodes.new("ShaderNodeTexImage")
        texture.image = image
        shader = material.node_tree.nodes["Principled BSDF"]
        material.node_tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
        shader.inputs["Roughness"].default_value = 1
    return obj


def textured_pieces():
    """The pieces of textured() along a wave."""
    textured()
    line = across()
    bpy.ops.talweg.separate()
    bpy.data.objects.remove(line)
    return [o for o in bpy.data.objects if o.type == "MESH"]


class Dressed(unittest.TestCase):
    def setUp(self):
        scene.empty()
        session.forget()
        self.obj = scene.add_mesh(support.hills()[0], quads())
        dressed(self.obj)

    def check(self, obj, seams=True):
        """Checks the data of dressed() by the places of the vertices."""
        mesh = obj.data
        self.assertFalse(mesh.validate())
        xyz = scene.vertices_of(obj)
        at_loops = xyz[attributes.read(mesh.loops, "vertex_index", 1, np.int32)]
        np.testing.assert_allclose(attributes.read(mesh.uv_layers["Map"].data, "uv", 2),
                                   uv_of(at_loops), atol=1e-5)
        paint = attributes.read(mesh.color_attributes["Paint"].data, "color_srgb", 4)
        np.testing.assert_allclose(paint[:, :2], uv_of(at_loops), atol=1.01 / 255)
        np.testing.assert_allclose(attributes.read(mesh.attributes["height"].data, "value"), xyz[:, 2],
                                   atol=1e-4)
        centres = attributes.read(mesh.polygons, "center", 3)
        clear = np.abs(centres[:, 0] - 20) > 1e-3
        smooth = attributes.read(mesh.polygons, "use_smooth", 1, bool)
        np.testing.assert_array_equal(smooth[clear], centres[clear, 0] > 20)
        self.assertEqual([material.name.split(".")[0] for material in mesh.materials], ["Below", "Above"])
        edges = xyz[attributes.read(mesh.edges, "vertices", 2, np.int32)]
        for name, axis, place, value in (("use_seam", 0, 20, 1), ("use_edge_sharp", 1, 40, 1),
                                         ("crease", 0, 40, 0.5)):
            told = attributes.read(mesh.edges, name)
            along = (np.abs(edges[..., axis] - place) < 1e-5).all(axis=1)
            np.testing.assert_allclose(told, along * value, atol=0.01, err_msg=name)
            if seams:
                length = np.linalg.norm(edges[along, 0] - edges[along, 1], axis=1).sum()
                self.assertGreater(length, 59)

    def weights(self, obj):
        found = np.zeros(len(obj.data.vertices))
        for vertex in obj.data.vertices:
            for group in vertex.groups:
                found[vertex.index] = group.weight
        return found

    def refused(self, words, operator, **how):
        before = scene.vertices_of(self.obj)
        objects = len(bpy.data.objects)
        with self.assertRaises(RuntimeError) as caught:
            operator(**how)
        self.assertIn(words, str(caught.exception))
        self.assertEqual(len(bpy.data.objects), objects)
        np.testing.assert_array_equal(scene.vertices_of(self.obj), before)


class Meshes(Dressed):
    def test_cut(self):
        area = sum(polygon.area for polygon in self.obj.data.polygons)
        across()
        self.assertEqual(bpy.ops.talweg.cut(), {"FINISHED"})
        self.check(self.obj)
        mesh = self.obj.data
        materials = attributes.read(mesh.polygons, "material_index", 1, np.int32)
        centres = attributes.read(mesh.polygons, "center", 3)
        np.testing.assert_array_equal(materials, centres[:, 1] > 30)
        chosen = np.array([edge.select for edge in mesh.edges])
        ends = attributes.read(mesh.edges, "vertices", 2, np.int32)[chosen]
        xyz = scene.vertices_of(self.obj)
        on_curve = xyz[np.unique(ends)]
        off = np.abs(on_curve[:, 1] - 25.3 - 4 * np.sin(on_curve[:, 0] / 6))
        self.assertLess(off.max(), 0.05)
        self.assertEqual((np.bincount(ends.ravel()) == 1).sum(), 2)  # one line from side to side
        totals = attributes.read(mesh.polygons, "loop_total", 1, np.int32)
        self.assertGreater((totals == 4).sum(), 59 * 59 - 250)  # polygons away from the cut stay
        self.assertAlmostEqual(sum(p.area for p in mesh.polygons) / area, 1, places=3)
        weights = self.weights(self.obj)
        inner = (xyz[:, 0] > 31) | (xyz[:, 0] < 30)
        np.testing.assert_array_equal(weights[inner], xyz[inner, 0] > 30.2)
        between = ~inner
        np.testing.assert_allclose(weights[between], xyz[between, 0] - 30, atol=1e-4)
        self.assertEqual(len(mesh.vertices) - len(mesh.edges) + len(mesh.polygons), 1)

    def test_cut_along_the_last_result_is_exact(self):
        scene.select_edges(self.obj, [10 * N + k for k in range(5, 31)]
                           + [k * N + 30 for k in range(11, 50)])
        self.assertEqual(bpy.ops.talweg.smooth_edges(), {"FINISHED"})
        bpy.ops.object.mode_set(mode="OBJECT")
        result = session.last_result().curve
        made, = [o for o in bpy.data.objects if o.type == "CURVE"]
        bpy.ops.object.select_all(action="DESELECT")
        made.select_set(True)
        self.obj.select_set(True)
        bpy.context.view_layer.objects.active = self.obj
        self.assertEqual(bpy.ops.talweg.cut(), {"FINISHED"})
        self.check(self.obj)
        ends = np.array([edge.vertices[:] for edge in self.obj.data.edges if edge.select])
        self.assertEqual(len(ends), len(result) - 1)
        points = scene.vertices_of(self.obj)[np.unique(ends)]
        ours = result.positions.astype(np.float32)
        np.testing.assert_array_equal(points[np.lexsort(points.T)], ours[np.lexsort(ours.T)])

        # A second cut, of the cut mesh, which already has the curve.
        before = len(self.obj.data.vertices), len(self.obj.data.polygons)
        self.assertEqual(bpy.ops.talweg.cut(), {"FINISHED"})
        self.check(self.obj)
        self.assertEqual((len(self.obj.data.vertices), len(self.obj.data.polygons)), before)
        self.assertEqual(sum(edge.select for edge in self.obj.data.edges), len(result) - 1)

    def test_separate(self):
        across()
        self.assertEqual(bpy.ops.talweg.separate(), {"FINISHED"})
        pieces = [o for o in bpy.data.objects if o.type == "MESH"]
        self.assertEqual(len(pieces), 2)
        for piece in pieces:
            self.check(piece, seams=False)
            self.assertEqual(piece.vertex_groups.keys(), ["Right"])
            self.assertEqual(talweg.inspect(support_arrays(piece))["components"], 1)
        means = sorted(scene.vertices_of(piece)[:, 1].mean() for piece in pieces)
        self.assertLess(means[0], 25)
        self.assertGreater(means[1], 25)

    def test_separate_keeps_a_side(self):
        across()
        self.assertEqual(bpy.ops.talweg.separate(keep="left"), {"FINISHED"})
        self.assertEqual(len([o for o in bpy.data.objects if o.type == "MESH"]), 1)
        self.check(self.obj, seams=False)

    def test_borders_of_materials(self):
        self.assertEqual(bpy.ops.talweg.material_borders(tau=2), {"FINISHED"})
        self.check(self.obj)
        materials = attributes.read(self.obj.data.polygons, "material_index", 1, np.int32)
        self.assertEqual(set(materials.tolist()), {0, 1})
        of = {}
        for polygon in self.obj.data.polygons:
            for key in polygon.edge_keys:
                of.setdefault(key, set()).add(materials[polygon.index])
        border = {key for key, found in of.items() if len(found) == 2}
        self.assertEqual(border, {tuple(sorted(edge.vertices)) for edge in self.obj.data.edges
                                  if edge.select})

    def test_borders_of_a_vertex_group(self):
        self.assertEqual(bpy.ops.talweg.group_borders(), {"FINISHED"})
        self.check(self.obj)
        weights = self.weights(self.obj)
        self.assertEqual(set(weights.tolist()), {0, 1})
        ends = {v for edge in self.obj.data.edges if edge.select for v in edge.vertices}
        self.assertTrue((weights[list(ends)] == 1).all())
        x = scene.vertices_of(self.obj)[:, 0]
        self.assertTrue((weights[x > 33] == 1).all())
        self.assertTrue((weights[x < 28] == 0).all())

    def test_repair(self):
        bpy.ops.object.select_all(action="DESELECT")
        self.obj.select_set(True)
        bpy.ops.object.mode_set(mode="EDIT")  # separate faces, one of them inverted
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.edge_split(type="EDGE")
        bpy.ops.object.mode_set(mode="OBJECT")
        self.obj.data.polygons[100].flip()
        self.obj.data.update()
        self.assertGreater(len(self.obj.data.vertices), 2 * N * N)
        self.assertEqual(bpy.ops.talweg.repair(), {"FINISHED"})
        self.assertEqual((len(self.obj.data.vertices), len(self.obj.data.polygons)), (N * N, 59 * 59))
        self.check(self.obj)
        normals = attributes.read(self.obj.data.polygons, "normal", 3)
        self.assertTrue((normals[:, 2] > 0).all() or (normals[:, 2] < 0).all())

    def test_vertices_that_nearly_coincide(self):
        """Separate faces, one of them moved a little."""
        bpy.ops.object.select_all(action="DESELECT")
        self.obj.select_set(True)
        whole = len(self.obj.data.vertices)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.edge_split(type="EDGE")
        bpy.ops.object.mode_set(mode="OBJECT")
        for vertex in self.obj.data.polygons[100].vertices:
            self.obj.data.vertices[vertex].co.z += 1e-4
        self.obj.data.update()
        self.assertEqual(bpy.ops.talweg.repair(), {"FINISHED"})
        self.assertGreater(len(self.obj.data.vertices), whole)
        self.assertEqual(bpy.ops.talweg.repair(weld_within=1e-3), {"FINISHED"})
        self.assertEqual(len(self.obj.data.vertices), whole)

    def test_the_sidebar_lists_the_changes(self):
        self.obj.data.polygons[100].flip()
        self.obj.data.update()
        bpy.ops.talweg.repair()
        self.assertRegex(last_report.of(self.obj)[0], "2 faces were turned")
        self.assertEqual(last_report.of(None), ("", ()))
        bpy.ops.talweg.repair()
        self.assertIn("needs no repair", last_report.of(self.obj)[0])
        last_report._forget()
        self.assertEqual(last_report.of(self.obj)[0], "")

    def test_edit_mode(self):
        """Data survive in edit mode, too."""
        self.obj.data.polygons[100].flip()
        self.obj.data.update()
        bpy.ops.object.mode_set(mode="EDIT")
        self.assertEqual(bpy.ops.talweg.repair(), {"FINISHED"})
        self.assertEqual(self.obj.mode, "EDIT")
        scene.select_edges(self.obj, [N * 20 + k for k in range(10, 40)])
        self.assertEqual(bpy.ops.talweg.smooth_edges(output="EDGES"), {"FINISHED"})
        self.assertEqual(self.obj.mode, "EDIT")
        bpy.ops.object.mode_set(mode="OBJECT")
        self.check(self.obj)

    def test_bad_input(self):
        ops = bpy.ops.talweg
        for operator in (ops.cut, ops.separate):
            self.refused("No curve object is selected", operator)
        self.refused("No step", ops.repair, weld=False, drop=False, orient=False, split=False)
        bad = curve_object(np.array([[1, 1, np.nan], [5, 5, 0]]))
        self.refused("not finite", ops.cut)
        bpy.data.objects.remove(bad)
        nurbs = curve_object(np.array([[1, 1, 0], [5, 5, 0], [9, 2, 0]]), kind="NURBS")
        self.refused("NURBS", ops.cut)
        bpy.data.objects.remove(nurbs)
        across()
        self.obj.data.polygons[7].flip()
        self.obj.data.update()
        for operator in (ops.cut, ops.separate, ops.material_borders, ops.group_borders):
            self.refused("opposite orientation", operator)
        self.obj.data.polygons[7].flip()
        self.obj.vertex_groups.clear()
        self.refused("no vertex group", ops.group_borders)
        self.obj.modifiers.new("Details", "MULTIRES")
        for operator in (ops.cut, ops.separate, ops.material_borders, ops.repair):
            self.refused("Multiresolution", operator)
        self.obj.modifiers.clear()
        self.obj.hide_set(True)
        bpy.context.view_layer.objects.active = self.obj
        self.refused("hidden", ops.repair)

    def test_a_cut_mesh_can_be_cut_again(self):
        """Polygons on both sides of a nearly straight line must not share a triangle."""
        across()
        self.assertEqual(bpy.ops.talweg.cut(), {"FINISHED"})
        self.assertEqual(talweg.inspect(support_arrays(self.obj))["verdict"], "usable")
        for name in ("material_borders", "group_borders"):
            self.assertEqual(getattr(bpy.ops.talweg, name)(), {"FINISHED"})
            self.assertEqual(talweg.inspect(support_arrays(self.obj))["verdict"], "usable", name)

    def test_errors_of_jobs_name_the_curve(self):
        """The work ends with an error on its thread; the steps add the curve's name."""

        def fails(_progress):
            raise talweg.BadCurve("Curve 0: it is bad.")

        def steps():
            with named(["Line"]):
                yield fails

        for end in (lambda: jobs.now(steps()), lambda: finished(steps())):
            with self.assertRaisesRegex(talweg.BadCurve, "^Line: it is bad"):
                end()

    def test_objects_with_the_same_mesh(self):
        twin = bpy.data.objects.new("Twin", self.obj.data)
        bpy.context.scene.collection.objects.link(twin)
        across()
        self.assertEqual(bpy.ops.talweg.separate(), {"FINISHED"})
        self.assertEqual(len(twin.data.vertices), N * N)  # the other object keeps the whole mesh
        self.assertEqual(len({o.data for o in bpy.data.objects if o.type == "MESH"}), 3)
        self.assertEqual(objects.warnings(twin, []), [])
        other = bpy.data.objects.new("Other", twin.data)
        self.assertEqual(objects.warnings(twin, []), ["Other shows the same mesh and changed, too."])


def finished(steps):
    """The result of steps, with their work on its thread."""
    job = jobs.Job(next(steps))
    job.is_done(wait=60)
    return jobs.after(steps, job.result)


def support_arrays(obj):
    obj.data.calc_loop_triangles()
    return (scene.vertices_of(obj), attributes.read(obj.data.loop_triangles, "vertices", 3, np.int32))
