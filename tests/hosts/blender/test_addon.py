"""The operators: the driver's results bit for bit, curve objects, cuts, errors, and kept surfaces."""

import json
import tempfile
import types
import unittest
from pathlib import Path

import bmesh
import bpy
import numpy as np
from talweg_blender import drawings, parameters, session
from talweg_blender.package import talweg

import scene
import support


def curve_objects():
    return [o for o in bpy.data.objects if o.type == "CURVE"]


def area(obj):
    return sum(polygon.area for polygon in obj.data.polygons)


class Addon(unittest.TestCase):
    def setUp(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())
        self.drawn = support.staircase()

    def smooth(self, expected="FINISHED", **parameters):
        self.assertEqual(bpy.ops.talweg.smooth_edges(**parameters), {expected})
        return session.last_result()

    def driver(self, faces, drawn, *options):
        """The driver's curve on the mesh with Blender's rounded vertices."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            support.write_obj(folder / "mesh.obj", scene.vertices_of(self.obj), faces)
            (folder / "drawn.txt").write_text("\n".join(map(str, drawn)))
            support.driver(folder, "smooth", "mesh.obj", "--curve", "drawn.txt", *options,
                           "-o", "out.json")
            return support.driver_curves(folder / "out.json")[0]

    def equal(self, theirs, curve):
        closed, faces, barycentrics, positions = theirs
        self.assertEqual(closed, curve.closed)
        np.testing.assert_array_equal(faces, curve.faces)
        np.testing.assert_array_equal(barycentrics, curve.barycentrics)
        np.testing.assert_array_equal(positions, curve.positions)

    def test_selected_edges_give_the_drivers_curve(self):
        faces = support.hills()[1]
        scene.select_edges(self.obj, self.drawn)
        for options, parameters in (
                ([], {}), (["--tau", "0"], {"tau": 0}), (["--tau", "2.5"], {"tau": 2.5}),
                (["--slack", "0.5"], {"use_slack": True, "slack": 0.5}),
                (["--max-deviation", "1.5"], {"use_max_deviation": True, "max_deviation": 1.5}),
                (["--potential", "paper", "--relax", "5"], {"potential": "paper", "relax": 5})):
            with self.subTest(parameters):
                result = self.smooth(**parameters)
                self.equal(self.driver(faces, self.drawn, *options), result.curve)
                shown, = curve_objects()
                np.testing.assert_array_equal(scene.spline_points(shown),
                                              result.curve.positions.astype(np.float32))
                self.assertFalse(shown.data.splines[0].use_cyclic_u)
                self.assertEqual(shown.matrix_world, self.obj.matrix_world)
                self.assertEqual(json.loads(shown["talweg_report"])["curvature_after"],
                                 result.total.curvature_after)
                bpy.data.objects.remove(shown)

    def test_options_that_are_not_ticked_show_the_used_values(self):
        panel = types.SimpleNamespace(mean_edge=0, use_slack=False, slack=1, shown_slack=1,
                                      use_max_deviation=True, max_deviation=1, shown_max_deviation=1,
                                      use_click_distance=True, click_distance=1, shown_click_distance=1)
        result = talweg.smooth(support.hills(), self.drawn)
        parameters.show_used(panel, result.total)
        self.assertEqual((panel.slack, panel.max_deviation), (result.total.slack, 1))
        panel.slack = 0.25  # as typed by a user
        parameters.show_used(panel, result.total)
        self.assertEqual(panel.slack, 0.25)

    def test_a_loop(self):
        scene.empty()
        vertices, faces = support.torus()
        self.obj = scene.add_mesh(vertices, faces)
        scene.select_edges(self.obj, support.ring(), closed=True)
        result = self.smooth(tau=2)
        self.assertTrue(result.curve.closed)
        self.assertTrue(curve_objects()[0].data.splines[0].use_cyclic_u)
        # A selection of edges has neither a beginning nor a direction of a loop: the add-on chooses both.
        self.obj.update_from_editmode()
        drawn = drawings.selected_edges(self.obj.data).curves[0].vertices
        self.assertEqual(sorted(drawn), sorted(support.ring()))
        self.equal(self.driver(faces, [*drawn, drawn[0]], "--tau", "2"), result.curve)

    def test_several_curves_with_a_junction_and_quads(self):
        scene.empty()
        n = 60
        a = np.arange(n * n).reshape(n, n)[:-1, :-1].ravel()
        quads = np.stack([a, a + n, a + n + 1, a + 1], -1)
        self.obj = scene.add_mesh(support.hills()[0], quads)
        row = [30 * n + k for k in range(5, 55)]
        column = [k * n + 30 for k in range(30, 55)]
        scene.select_edges(self.obj, row)
        bm = bmesh.from_edit_mesh(self.obj.data)
        bm.verts.ensure_lookup_table()
        for p, q in zip(column, column[1:]):
            bm.edges.get((bm.verts[p], bm.verts[q])).select_set(True)
        bmesh.update_edit_mesh(self.obj.data)
        result = self.smooth()
        self.assertEqual(len(result.curves), 3)
        self.assertEqual(len(curve_objects()[0].data.splines), 3)
        ends = [curve.vertices[k] for curve in result.curves for k in (0, -1)]
        self.assertEqual(ends.count(30 * n + 30), 3)

    def test_a_tau_and_a_slack_for_each_curve(self):
        rows = [[row * 60 + k for k in range(5, 55)] for row in (10, 30)]
        scene.select_edges(self.obj, rows[0])
        bm = bmesh.from_edit_mesh(self.obj.data)
        bm.verts.ensure_lookup_table()
        for a, b in zip(rows[1], rows[1][1:]):
            bm.edges.get((bm.verts[a], bm.verts[b])).select_set(True)
        bmesh.update_edit_mesh(self.obj.data)
        mesh = talweg.Mesh(scene.vertices_of(self.obj), support.hills()[1])
        drawn = [talweg.Curve(vertices=row) for row in rows]
        for shown, of_python in (({"taus": "0.1, 4"}, {"tau": [0.1, 4]}),
                                 ({"tau": 3, "taus": "0.1 -1"}, {"tau": [0.1, 3]}),
                                 ({"slacks": "-1;0.5"}, {"slack": [None, 0.5]}), ({}, {})):
            with self.subTest(shown):
                ours = self.smooth(**{"tau": 1, "taus": "", "slacks": "", **shown})
                for mine, theirs in zip(ours.curves, mesh.smooth(drawn, **of_python).curves,
                                        strict=True):
                    np.testing.assert_array_equal(mine.faces, theirs.faces)
                    np.testing.assert_array_equal(mine.barycentrics, theirs.barycentrics)

    def test_a_moved_tau_costs_only_its_stage(self):
        scene.select_edges(self.obj, self.drawn)
        first = self.smooth(tau=1).total.time_ms
        kept = session._Kept.surfaces[-1]  # pylint: disable=protected-access
        again = self.smooth(tau=2).total.time_ms
        self.assertIs(session._Kept.surfaces[-1], kept)  # pylint: disable=protected-access
        self.assertEqual((again["open"], again["solve"]), (first["open"], first["solve"]))
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.transform.translate(value=(0, 0, 1))
        scene.select_edges(self.obj, self.drawn)
        self.smooth(tau=2)
        self.assertIsNot(session._Kept.surfaces[-1], kept)  # pylint: disable=protected-access

    def test_edges_of_the_mesh(self):
        for quads in (False, True):
            for closed in (False, True):
                with self.subTest(quads=quads, closed=closed):
                    self.cut(quads, closed)

    def cut(self, quads, closed):
        scene.empty()
        n = 60
        vertices, faces = support.torus() if closed else support.hills()
        if quads:
            a = np.arange(n * n).reshape(n, n)
            a = a if closed else a[:-1, :-1]
            i, k = np.divmod(a.ravel(), n)
            faces = np.stack([i * n + k, (i + 1) % n * n + k, (i + 1) % n * n + (k + 1) % n,
                              i * n + (k + 1) % n], -1)
        self.obj = scene.add_mesh(vertices, faces)
        before = (len(self.obj.data.vertices) - len(self.obj.data.edges)
                  + len(self.obj.data.polygons), area(self.obj))
        drawn = support.ring() if closed else self.drawn
        if quads:  # along the grid's lines
            drawn = np.array([i * n + 10 for i in range(n)] if closed else
                             [10 * n + k for k in range(5, 30)] + [k * n + 30 for k in range(10, 50)])
        scene.select_edges(self.obj, drawn, closed)
        result = self.smooth(tau=1, output="EDGES")
        bpy.ops.object.mode_set(mode="OBJECT")
        mesh = self.obj.data
        self.assertFalse(mesh.validate())  # True would mean that Blender had to repair the mesh
        self.assertEqual(len(curve_objects()), 0)
        self.assertEqual(len(mesh.vertices) - len(mesh.edges) + len(mesh.polygons), before[0])
        if not quads:  # quads of a curved surface are not planar
            self.assertAlmostEqual(area(self.obj) / before[1], 1, places=4)
        chosen = [edge for edge in mesh.edges if edge.select]
        xyz = scene.vertices_of(self.obj).astype(float)
        length = sum(np.linalg.norm(xyz[e.vertices[0]] - xyz[e.vertices[1]]) for e in chosen)
        self.assertAlmostEqual(length / result.curve.length, 1, places=5)
        ends = np.bincount([v for e in chosen for v in e.vertices])
        self.assertEqual(np.count_nonzero(ends == 1), 0 if closed else 2)
        self.assertEqual(ends.max(), 2)
        # The edges of the cut are a drawing of the same points.
        on_curve = xyz[np.nonzero(ends)[0]]
        nearest = np.abs(on_curve[:, None] - result.curve.positions[None]).max(2).min(1)
        self.assertLess(nearest.max(), 1e-5)

    def test_annotations(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        self.obj.matrix_world = ((0, -2, 0, 5), (2, 0, 0, -1), (0, 0, 2, 3), (0, 0, 0, 1))
        bpy.context.view_layer.update()
        matrix = np.array(self.obj.matrix_world)
        drawn = scene.vertices_of(self.obj)[self.drawn] @ matrix[:3, :3].T + matrix[:3, 3]
        scene.annotate([drawn])
        self.assertEqual(bpy.ops.talweg.smooth_annotations(tau=2), {"FINISHED"})
        result = session.last_result()
        shown = curve_objects()[0]
        self.assertEqual(shown.matrix_world, self.obj.matrix_world)
        np.testing.assert_array_equal(scene.spline_points(shown),
                                      result.curve.positions.astype(np.float32))
        self.assertLess(result.report.curvature_after, result.report.curvature_before / 4)
        # In the object's own units.
        np.testing.assert_allclose(result.curve.positions[0],
                                   scene.vertices_of(self.obj)[self.drawn[0]], atol=1e-5)

    def test_ends_that_meet(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        angles = np.linspace(0, 2 * np.pi - 0.08, 90)
        around = np.stack([20 + 8 * np.cos(angles), 20 + 8 * np.sin(angles)], -1)
        scene.annotate([np.c_[around, 3 * np.sin(around[:, 0] / 7) * np.cos(around[:, 1] / 5)]])
        self.assertEqual(bpy.ops.talweg.smooth_annotations(), {"FINISHED"})
        curve, = curve_objects()
        self.assertTrue(curve.data.splines[0].use_cyclic_u)
        self.assertTrue(any("taken as a loop" in one for one in session.last_result().total.warnings))
        curve.talweg.ends = "open"
        self.assertFalse(curve.data.splines[0].use_cyclic_u)
        curve.talweg.ends = "closed"
        self.assertTrue(curve.data.splines[0].use_cyclic_u)

    def test_a_hook_smaller_than_a_triangle(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        hook = [[10, 10, 0], [10.2, 10.1, 0], [10.1, 10.2, 0], [10.1, 10.0, 0], [20, 15, 0],
                [30, 30, 0], [30.1, 30.1, 0]]
        for point in hook:
            point[2] = 3 * np.sin(point[0] / 7) * np.cos(point[1] / 5)
        scene.annotate([hook])
        self.assertEqual(bpy.ops.talweg.smooth_annotations(), {"FINISHED"})
        ends = session.last_result().curve.positions[[0, -1]]
        np.testing.assert_allclose(ends[:, :2], [hook[0][:2], hook[-1][:2]], atol=1e-2)

    def test_a_stroke_inside_one_face_is_cut_whole(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        scene.annotate([[[10.2, 10.1, 0], [10.3, 10.15, 0]]])
        self.assertEqual(bpy.ops.talweg.smooth_annotations(output="EDGES"), {"FINISHED"})
        self.assertFalse(self.obj.data.validate())
        self.assertEqual(sum(edge.select for edge in self.obj.data.edges), 1)

    def test_annotations_cut_into_the_mesh(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        t = np.linspace(0, 1, 30)[:, None]
        ends = np.array([[5.3, 7.2, 0], [50.4, 41.7, 0]])
        line = ends[0] * (1 - t) + ends[1] * t
        line[:, 2] = 3 * np.sin(line[:, 0] / 7) * np.cos(line[:, 1] / 5)
        scene.annotate([line])
        self.assertEqual(bpy.ops.talweg.smooth_annotations(output="EDGES"), {"FINISHED"})
        self.assertFalse(self.obj.data.validate())
        chosen = sum(edge.select for edge in self.obj.data.edges)
        self.assertGreaterEqual(chosen, len(session.last_result().curve) - 3)


class Errors(unittest.TestCase):
    """Blender's kind of error with the library's sentence; Blender continues."""

    def setUp(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())

    def refused(self, words, operator=bpy.ops.talweg.smooth_edges, **parameters):
        before = len(bpy.data.objects)
        with self.assertRaises(RuntimeError) as caught:
            operator(**parameters)
        self.assertIn("Error: ", str(caught.exception))
        self.assertIn(words, str(caught.exception))
        self.assertEqual(len(bpy.data.objects), before)

    def still_alive(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())
        scene.select_edges(self.obj, support.staircase())
        self.assertEqual(bpy.ops.talweg.smooth_edges(), {"FINISHED"})
        self.assertEqual(session.last_result().total.termination, "converged")

    def test_nothing_is_selected(self):
        scene.select_edges(self.obj, [])
        self.refused("No edges are selected")
        self.still_alive()

    def test_faces_that_disagree(self):
        scene.select_edges(self.obj, support.staircase())
        bm = bmesh.from_edit_mesh(self.obj.data)
        bm.faces.ensure_lookup_table()
        bm.faces[7].normal_flip()
        bmesh.update_edit_mesh(self.obj.data)
        self.refused("orient")
        self.still_alive()

    def test_an_edge_without_faces(self):
        scene.empty()
        self.obj = scene.add_mesh([[0, 0, 0], [1, 0, 0]], [])
        bpy.ops.object.mode_set(mode="EDIT")
        bm = bmesh.from_edit_mesh(self.obj.data)
        bm.verts.ensure_lookup_table()
        bm.edges.new((bm.verts[0], bm.verts[1])).select_set(True)
        bmesh.update_edit_mesh(self.obj.data)
        self.refused("The mesh has no faces")
        self.still_alive()

    def test_parameters_that_do_not_go_together(self):
        scene.select_edges(self.obj, support.staircase())
        self.refused("slack needs the potential corridor", potential="paper", use_slack=True)
        self.still_alive()

    def test_numbers_of_curves(self):
        scene.select_edges(self.obj, support.staircase())
        self.refused("Tau of each curve (taus) has 2 values for 1 curves", taus="1 2")
        self.refused("Tau of each curve: 'much' is not a number", taus="much")
        self.refused("Slack of each curve: '0.5x' is not a number", slacks="0.5x")
        self.refused("Slack of each curve", slacks="nan")
        scene.select_edges(self.obj, support.staircase())
        self.assertEqual(bpy.ops.talweg.smooth_edges(taus="2", slacks=""), {"FINISHED"})
        self.assertEqual(session.last_result().report.tau, 2)
        bpy.ops.object.mode_set(mode="OBJECT")
        self.still_alive()

    def test_annotations(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        annotations = bpy.ops.talweg.smooth_annotations
        self.refused("There are no annotations", annotations)
        cross = [[10, 10, 0], [20, 20, 0], [20, 10, 0], [10, 20, 0]]
        scene.annotate([cross], mode="SCREEN")
        self.refused("not on a surface", annotations)
        scene.annotate([[[10, 10, 0], [15, 15, float("nan")], [20, 20, 0]]])
        self.refused("not finite", annotations)
        self.still_alive()

    def test_not_in_this_mode(self):
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertFalse(bpy.ops.talweg.smooth_edges.poll())
        bpy.ops.object.mode_set(mode="EDIT")
        self.assertTrue(bpy.ops.talweg.smooth_edges.poll())
        self.assertFalse(bpy.ops.talweg.smooth_annotations.poll())

    def test_a_cut_that_cannot_be_leaves_the_mesh_as_it_was(self):
        before = scene.vertices_of(self.obj)
        self.obj.modifiers.new("Details", "MULTIRES")
        scene.select_edges(self.obj, support.staircase())
        self.refused("Multiresolution", output="EDGES")
        bpy.ops.object.mode_set(mode="OBJECT")
        np.testing.assert_array_equal(scene.vertices_of(self.obj), before)
        self.still_alive()
