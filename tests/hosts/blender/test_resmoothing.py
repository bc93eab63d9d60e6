"""Curve objects store their drawing and values: a change of a value smooths the curve again, also in a later
session."""

import json
import tempfile
import unittest
from pathlib import Path

import bmesh
import bpy
import numpy as np
from talweg_blender import colours, drawings, operators, page, resmoothing, sentences, session
from talweg_blender.package import talweg

import scene
import support


def curve_objects():
    return [o for o in bpy.data.objects if o.type == "CURVE" and not o.get("talweg_colours")]


def report(curve):
    return json.loads(curve["talweg_report"])


class Again(unittest.TestCase):
    def setUp(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())
        scene.select_edges(self.obj, support.staircase())

    def made(self, **how):
        self.assertEqual(bpy.ops.talweg.smooth_edges(**how), {"FINISHED"})
        return curve_objects()[-1]

    def test_a_value_of_the_object_smooths_it_again(self):
        curve = self.made(tau=1)
        self.assertEqual(curve.talweg.tau, 1)
        mesh = talweg.Mesh(scene.vertices_of(self.obj), support.hills()[1])
        for change in ({"tau": 4}, {"use_slack": True, "slack": 0.5}, {"use_slack": False},
                       {"use_max_deviation": True, "max_deviation": 0.7}):
            for name, value in change.items():
                setattr(curve.talweg, name, value)
            wanted = {"tau": curve.talweg.tau}
            if curve.talweg.use_slack:
                wanted["slack"] = 0.5
            if curve.talweg.use_max_deviation:
                wanted["max_deviation"] = curve.talweg.max_deviation
            expected = mesh.smooth(support.staircase(), **wanted).curve
            np.testing.assert_array_equal(scene.spline_points(curve), expected.positions.astype(np.float32))

    def test_ridges_attract_it_and_the_panel_tells(self):
        """A stroke two edges beside a crease, which is at k = 30."""
        bpy.ops.object.mode_set(mode="OBJECT")
        vertices, faces = support.hills()
        vertices[:, 2] = -0.6 * np.abs(vertices[:, 1] - 30)
        scene.empty()
        self.obj = scene.add_mesh(vertices, faces)
        scene.select_edges(self.obj, [60 * row + 28 for row in range(10, 50)])
        curve = self.made()
        self.assertIsNone(session.last_result().total.ridge_moved)
        curve.talweg.ridges = 1
        self.assertGreater(session.last_result().total.ridge_moved, 0.9)
        middle = [p for p in scene.spline_points(curve) if 20 < p[0] < 40]
        self.assertLess(max(abs(p[1] - 30) for p in middle), 0.2)
        self.assertIn("were moved onto ridges, by up to 2.33", " ".join(sentences.others_of(report(curve))))
        curve.talweg.ridge_kind = "concave"
        self.assertEqual(session.last_result().total.ridge_moved, 0)
        self.assertIn("stays as it was drawn", " ".join(sentences.others_of(report(curve))))

    def test_options_that_are_not_ticked_show_the_used_values(self):
        curve = self.made()
        total = session.last_result().total
        self.assertAlmostEqual(curve.talweg.slack, total.slack, places=6)
        self.assertAlmostEqual(curve.talweg.max_deviation, total.farthest, places=6)
        curve.talweg.tau = 4
        self.assertAlmostEqual(curve.talweg.max_deviation, session.last_result().total.farthest,
                               places=6)

    def test_the_mesh_is_not_read_for_it(self):
        curve = self.made(tau=1)
        curve.talweg.tau = 2
        read, session._read = session._read, None  # pylint: disable=protected-access
        try:
            curve.talweg.tau = 3
        finally:
            session._read = read  # pylint: disable=protected-access
        self.assertEqual(report(curve)["tau"], 3)

    def test_a_mesh_that_has_changed_is_read(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        scene.annotate([scene.vertices_of(self.obj)[support.staircase()]])
        self.assertEqual(bpy.ops.talweg.smooth_annotations(), {"FINISHED"})
        curve, = curve_objects()
        for vertex in self.obj.data.vertices:
            vertex.co.z += 0.5
        curve.talweg.tau = 3
        heights = scene.vertices_of(self.obj)[:, 2]
        self.assertGreater(scene.spline_points(curve)[:, 2].min(), heights.min() - 1e-3)
        start = scene.spline_points(curve)[0]
        np.testing.assert_allclose(start, scene.vertices_of(self.obj)[support.staircase()[0]], atol=0.3)

    def test_modifiers_that_are_not_seen_now(self):
        """The curve stays on the modified mesh while the modifiers are not shown."""
        bpy.ops.object.mode_set(mode="OBJECT")
        self.obj.modifiers.new("Fine", "SUBSURF")
        scene.annotate([scene.vertices_of(self.obj)[support.staircase()]])
        self.assertEqual(bpy.ops.talweg.smooth_annotations(), {"FINISHED"})
        curve, = curve_objects()
        before = scene.spline_points(curve)
        bpy.ops.object.mode_set(mode="EDIT")
        curve.talweg.tau = 4
        np.testing.assert_array_equal(scene.spline_points(curve), before)
        bpy.ops.object.mode_set(mode="OBJECT")
        curve.talweg.tau = 5
        self.assertEqual(report(curve)["tau"], 5)

    def test_tomorrow(self):
        """A saved and loaded file has the values and the drawing, and gives the same curve."""
        curve = self.made(tau=2.5, thickness=0.5)
        before, name = scene.spline_points(curve), curve.name
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "scene.blend")
            bpy.ops.object.mode_set(mode="OBJECT")
            bpy.ops.wm.save_as_mainfile(filepath=path)
            session.forget()
            bpy.ops.wm.open_mainfile(filepath=path)
        curve = bpy.data.objects[name]
        self.assertEqual((curve.talweg.tau, curve.talweg.thickness), (2.5, 0.5))
        self.assertIn(f"Curvature {report(curve)['curvature_before']:.3g}", resmoothing.numbers(bpy.context, curve))
        curve.talweg.tau = 0
        self.assertEqual(report(curve)["tau"], 0)
        curve.talweg.tau = 2.5
        np.testing.assert_array_equal(scene.spline_points(curve), before)

    def test_errors_leave_the_curve_unchanged(self):
        curve = self.made()
        before = scene.spline_points(curve)
        curve.talweg.taus = "1 2 3"
        np.testing.assert_array_equal(scene.spline_points(curve), before)
        self.assertIn(curve.name, resmoothing._wrong)  # pylint: disable=protected-access
        curve.talweg.taus = ""
        self.assertNotIn(curve.name, resmoothing._wrong)  # pylint: disable=protected-access

    def test_thickness(self):
        curve = self.made()
        wide = curve.data.bevel_depth
        curve.talweg.thickness = 2
        self.assertAlmostEqual(curve.data.bevel_depth, 2 * wide, places=6)

    def test_colours(self):
        curve = self.made(colours="DEVIATION")
        shown, = [one for one in curve.children if one.get("talweg_colours")]
        result = session.last_result()
        deviation = result.curve.fields["deviation"]
        self.assertAlmostEqual(curve["talweg_range"], deviation.max(), places=12)
        self.assertGreater(shown.data.bevel_depth, curve.data.bevel_depth)
        self.assertTrue(shown.hide_select)
        splines = shown.data.splines
        self.assertEqual(sum(len(s.points) - 1 for s in splines), len(result.curve) - 1)
        for spline in splines:  # the classes are ninths of the range
            ends = np.array([point.co[:3] for point in spline.points])
            near = [int(np.abs(result.curve.positions - end).sum(axis=1).argmin()) for end in ends]
            values = [max(deviation[a], deviation[b]) for a, b in zip(near, near[1:])]
            for value in values:
                self.assertEqual(min(int(9 * value / deviation.max()), 8), spline.material_index)
        curve.talweg.colours = "TURNING"
        shown, = [one for one in curve.children if one.get("talweg_colours")]
        self.assertGreater(len({spline.material_index for spline in shown.data.splines}), 1)
        curve.talweg.colours = "PLAIN"
        self.assertEqual([one for one in curve.children if one.get("talweg_colours")], [])
        self.assertEqual(len([o for o in bpy.data.objects if o.type == "CURVE"]), 1)

    def test_turning_of_a_circle_is_its_curvature(self):
        """On a plane a circle of radius 10 turns by a tenth of a radian per unit."""
        t = np.linspace(0, 2 * np.pi, 200, endpoint=False)
        circle = talweg.Curve(positions=np.stack([10 * np.cos(t), 10 * np.sin(t), 0 * t], -1), closed=True,
                              fields={"curvature": np.full(200, 2 * np.pi / 200)})
        np.testing.assert_allclose(colours._turning(circle, 1.0), 0.1, rtol=0.1)

    def test_into_the_mesh(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        y = 20 * 60
        for output, member in (("SEAM", "use_seam"), ("SHARP", "use_edge_sharp"), ("EDGES", "select"),
                               ("OPEN", "select"), ("SEPARATE", "select")):
            with self.subTest(output):
                scene.empty()
                self.obj = scene.add_mesh(*support.hills())
                scene.select_edges(self.obj, [y + k for k in range(60)])
                curve = self.made(tau=2)
                bpy.ops.object.mode_set(mode="OBJECT")
                bpy.context.view_layer.objects.active = curve
                self.assertEqual(bpy.ops.talweg.to_mesh(output=output), {"FINISHED"})
                meshes = [o for o in bpy.data.objects if o.type == "MESH"]
                self.assertEqual(len(meshes), 2 if output == "SEPARATE" else 1)
                self.assertFalse(self.obj.data.validate())
                xyz = scene.vertices_of(self.obj).astype(float)
                marked = [edge for edge in self.obj.data.edges if getattr(edge, member)]
                length = sum(np.linalg.norm(xyz[e.vertices[0]] - xyz[e.vertices[1]]) for e in marked)
                sides = 2 if output == "OPEN" else 1
                self.assertAlmostEqual(length / sides / session.last_result().curve.length, 1, places=4)

    def test_marks_of_the_operator(self):
        scene.select_edges(self.obj, support.staircase())
        self.assertEqual(bpy.ops.talweg.smooth_edges(output="SEAM"), {"FINISHED"})
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertTrue(any(edge.use_seam for edge in self.obj.data.edges))
        self.assertEqual(curve_objects(), [])


class Drawings(unittest.TestCase):
    def setUp(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())

    def test_several_objects_in_edit_mode(self):
        other = scene.add_mesh(*support.torus(), name="Ring")
        self.obj.select_set(True)
        scene.select_edges(self.obj, support.staircase())  # both objects are in edit mode
        self.assertEqual(other.mode, "EDIT")
        bm = bmesh.from_edit_mesh(other.data)
        bm.verts.ensure_lookup_table()
        ring = support.ring()
        for a, b in zip(ring, np.roll(ring, -1)):
            bm.edges.get((bm.verts[int(a)], bm.verts[int(b)])).select_set(True)
        bmesh.update_edit_mesh(other.data)
        self.assertEqual(bpy.ops.talweg.smooth_edges(), {"FINISHED"})
        self.assertEqual({one.parent.name for one in curve_objects()}, {"Mesh", "Ring"})
        # One drawing is refused; the other curve is made.
        for one in curve_objects():
            bpy.data.objects.remove(one)
        bm = bmesh.from_edit_mesh(other.data)
        bm.faces.ensure_lookup_table()
        bm.faces[7].normal_flip()
        bmesh.update_edit_mesh(other.data)
        self.assertEqual(bpy.ops.talweg.smooth_edges(), {"FINISHED"})
        self.assertEqual([one.parent.name for one in curve_objects()], ["Mesh"])

    def test_wire_edges_are_told(self):
        bpy.ops.object.mode_set(mode="EDIT")
        bm = bmesh.from_edit_mesh(self.obj.data)
        ends = [bm.verts.new((k, 0, 9)) for k in (0, 1)]
        edge = bm.edges.new(ends)
        bmesh.update_edit_mesh(self.obj.data)
        bpy.ops.object.mode_set(mode="OBJECT")
        scene.select_edges(self.obj, [])
        bm = bmesh.from_edit_mesh(self.obj.data)
        edge = next(one for one in bm.edges if not one.link_faces)
        edge.select_set(True)
        bmesh.update_edit_mesh(self.obj.data)
        with self.assertRaisesRegex(RuntimeError, "wire, without a face .first: between vertices 3600 and 3601"):
            bpy.ops.talweg.smooth_edges()
        scene.select_edges(self.obj, support.staircase())
        bm = bmesh.from_edit_mesh(self.obj.data)
        next(one for one in bm.edges if not one.link_faces).select_set(True)
        bmesh.update_edit_mesh(self.obj.data)
        self.assertEqual(bpy.ops.talweg.smooth_edges(), {"FINISHED"})

    def test_bezier_points_are_way_points_and_poly_points_a_stroke(self):
        clicks = np.array([[10, 10, 0], [30, 20, 0], [45, 45, 0]], float)
        clicks[:, 2] = 3 * np.sin(clicks[:, 0] / 7) * np.cos(clicks[:, 1] / 5)
        data = bpy.data.curves.new("Bow", "CURVE")
        data.dimensions = "3D"
        spline = data.splines.new("BEZIER")
        spline.bezier_points.add(2)
        for point, place in zip(spline.bezier_points, clicks):
            point.co = place
        bow = bpy.data.objects.new("Bow", data)
        bpy.context.scene.collection.objects.link(bow)
        bow.select_set(True)
        self.assertEqual(bpy.ops.talweg.smooth_objects(), {"FINISHED"})
        positions = session.last_result().curve.positions
        off = np.linalg.norm(positions[:, None] - clicks[None], axis=2).min(axis=0)
        self.assertLess(off.max(), 0.05)  # the hills' triangles are flat
        self.assertTrue((np.asarray(session.last_result().drawn[0].exact) == True).all())  # noqa: E712

    def test_grease_pencil(self):
        self.obj.location.x = 3
        bpy.context.view_layer.update()
        data = bpy.data.grease_pencils.new("Pencil")
        frame = data.layers.new("Lines").frames.new(bpy.context.scene.frame_current)
        for y in (10, 30):
            stroke = frame.strokes.new()
            stroke.points.add(40)
            x = np.linspace(5, 50, 40)
            points = np.stack([x + 3, np.full(40, y), 3 * np.sin(x / 7) * np.cos(y / 5)], -1)
            stroke.points.foreach_set("co", points.astype(np.float32).ravel())
        pencil = bpy.data.objects.new("Pencil", data)
        bpy.context.scene.collection.objects.link(pencil)
        pencil.select_set(True)
        self.assertEqual(bpy.ops.talweg.smooth_objects(), {"FINISHED"})
        self.assertEqual(len(session.last_result().curves), 2)
        self.assertEqual(bpy.ops.talweg.smooth_objects(strokes="1"), {"FINISHED"})
        self.assertAlmostEqual(session.last_result().curve.positions[0][1], 30, places=1)

    def test_a_mesh_of_another_file(self):
        """Curves can be drawn on a mesh of a library; only the mesh itself cannot be changed."""
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "other.blend")
            bpy.data.libraries.write(path, {self.obj}, fake_user=True)
            scene.empty()
            with bpy.data.libraries.load(path, link=True) as (_, wanted):
                wanted.objects = ["Mesh"]
            obj, = wanted.objects
            bpy.context.scene.collection.objects.link(obj)
            bpy.context.view_layer.objects.active = obj
            x = np.linspace(5, 50, 60)
            line = np.stack([x, np.full(60, 10.0), 3 * np.sin(x / 7) * np.cos(2)], -1)
            scene.annotate([line])
            self.assertEqual(bpy.ops.talweg.smooth_annotations(), {"FINISHED"})
            self.assertEqual(len(curve_objects()), 1)
            with self.assertRaisesRegex(RuntimeError, "is linked from a library and cannot be changed"):
                bpy.ops.talweg.smooth_annotations(output="EDGES")
            scene.empty()


class Repaired(unittest.TestCase):
    """A mesh with one inverted face, which has 3 wrong edges and is refused unrepaired."""

    def setUp(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())
        scene.select_edges(self.obj, support.staircase())
        bm = bmesh.from_edit_mesh(self.obj.data)
        bm.faces.ensure_lookup_table()
        bm.faces[3000].normal_flip()
        bmesh.update_edit_mesh(self.obj.data)

    def test_repair_is_offered(self):
        with self.assertRaises(RuntimeError) as caught:
            bpy.ops.talweg.smooth_edges()
        for words in ("3 edges join two faces of opposite orientation", "can be repaired (orient)",
                      "On a repaired copy"):
            self.assertIn(words, str(caught.exception))

    def test_on_a_repaired_copy(self):
        self.obj.update_from_editmode()
        flipped = [polygon.normal.z for polygon in self.obj.data.polygons]
        self.assertEqual(bpy.ops.talweg.smooth_edges(repair=True), {"FINISHED"})
        curve, = curve_objects()
        self.assertTrue(any("1 face" in one for one in session.last_result().total.warnings))
        curve.talweg.tau = 3
        self.assertEqual(report(curve)["tau"], 3)
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertEqual([polygon.normal.z for polygon in self.obj.data.polygons], flipped)
        scene.select_edges(self.obj, support.staircase())
        with self.assertRaisesRegex(RuntimeError, "only curve objects"):
            bpy.ops.talweg.smooth_edges(repair=True, output="EDGES")

    def test_repair_in_edit_mode(self):
        self.assertEqual(bpy.ops.talweg.repair(), {"FINISHED"})
        self.assertEqual(self.obj.mode, "EDIT")
        scene.select_edges(self.obj, support.staircase())
        self.assertEqual(bpy.ops.talweg.smooth_edges(), {"FINISHED"})

    def test_an_unrepairable_mesh_offers_no_repair(self):
        scene.empty()
        self.obj = scene.add_mesh([[0, 0, 0], [1, 0, 0]], [])
        scene.annotate([[[0, 0, 0], [1, 0, 0]]])
        with self.assertRaises(RuntimeError) as caught:
            bpy.ops.talweg.smooth_annotations()
        self.assertNotIn("repair", str(caught.exception))


class Refused(unittest.TestCase):
    def test_a_stroke_that_the_library_refuses_is_left_out(self):
        curves = [talweg.Curve(vertices=[k, k + 1]) for k in range(3)]
        drawing = drawings.Drawing(curves, "key", ["Stroke 0", "Stroke 2", "Stroke 20"], ["first"])
        left = operators._without(drawing, "Stroke 2: it cannot be done.")
        self.assertEqual((left.names, left.curves), (["Stroke 0", "Stroke 20"], [curves[0], curves[2]]))
        self.assertEqual(left.warnings, ["first", "Left out: Stroke 2: it cannot be done."])
        self.assertIsNone(operators._without(drawing, "Something else."))
        alone = drawings.Drawing(curves[:1], "key", ["Stroke 0"])
        self.assertIsNone(operators._without(alone, "Stroke 0: it cannot be done."))


class Page(unittest.TestCase):
    def test_it_comes_with_the_add_on(self):
        text = page.written().read_text(encoding="utf-8")
        self.assertIn("<h1>Talweg in Blender</h1>", text)
        self.assertNotIn("](", text)
        folder = Path(page.__file__).parent / "page"
        for name in ("blender.md", "pictures/blender.png"):
            self.assertTrue((folder / name).is_file(), name)

    def test_blocks(self):
        text = "# A *b*\n\n- one `x<y`\n  more\n- two\n\n```sh\na < b\n```\n\n[c](d.md) **e**\n"
        made = page.as_html(text, Path("/"))
        for words in ("<h1>A <i>b</i></h1>", "<li>one <code>x&lt;y</code>\n  more</li><li>two</li>",
                      "<pre>a &lt; b\n</pre>", "<p>c <b>e</b></p>"):
            self.assertIn(words, made)
