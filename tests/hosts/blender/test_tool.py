"""The drawing tool without a window: mouse actions on a view, undo, its thread, and its end."""

import runpy
import threading
import unittest
import unittest.mock
from pathlib import Path

import bpy
import numpy as np
from talweg_blender import panel, resmoothing, session
from talweg_blender.drawing_tool import drawn, lines, tool
from talweg_blender.drawing_tool import view as seen
from talweg_blender.drawing_tool.live import Live, Request
from talweg_blender.drawing_tool.view import View
from talweg_blender.package import talweg

import scene
import support

WIDTH, HEIGHT = 640, 640


def hill(x, y):
    return 3 * np.sin(x / 7) * np.cos(y / 5)


def from_above():
    """An orthographic view down on the hills, ten pixels for each unit."""
    matrix = np.eye(4)
    matrix[0, 0], matrix[0, 3] = 20 / WIDTH, -1
    matrix[1, 1], matrix[1, 3] = 20 / HEIGHT, -1
    matrix[2, 2] = -1 / 100
    return View(matrix, WIDTH, HEIGHT)


def pixel(x, y):
    return np.array([10.0 * x, 10.0 * y])


def curve_objects():
    return [o for o in bpy.data.objects if o.type == "CURVE"]


class Views(unittest.TestCase):
    def test_rays_meet_the_projected_points(self):
        """In a perspective view, too, a point lies on the ray through its pixel."""
        perspective = np.array([[1.2, 0, 0, 0], [0, 1.6, 0, 0], [0, 0, -1.002, -0.2], [0, 0, -1, 0]])
        turned = np.eye(4)
        turned[:3, 3] = (0.3, -0.2, -5)
        view = View(perspective @ turned, 800, 600)
        for point in ((0, 0, 0), (1, 0.5, -2), (-0.7, 0.3, 1)):
            flat = view.project([point])[0]
            origin, direction = view.ray(flat)
            off = np.cross(np.subtract(point, origin), direction)
            self.assertLess(np.linalg.norm(off), 1e-9)
        self.assertTrue(np.isnan(view.project([[0, 0, 9]])).all())  # behind the eye

    def test_a_pixel(self):
        self.assertAlmostEqual(from_above().pixel_at([20, 30, 0]), 0.1)

    def test_nearest_points_and_segments(self):
        flat = np.array([[0, 0], [10, 0], [10, 10]], float)
        self.assertEqual(seen.nearest_point(flat, [9, 1], 3), [1])
        self.assertEqual(seen.nearest_point(flat, [5, 5], 3), [])
        self.assertEqual(seen.nearest_segment(flat, False, [10, 4], 3)[:2], (1, 0.4))
        self.assertEqual(seen.nearest_segment(flat, True, [5, 5], 3)[0], 2)
        self.assertIsNone(seen.nearest_segment(flat, False, [5, 5], 3))


class Lines(unittest.TestCase):
    @staticmethod
    def line(count, exact=()):
        return lines.Line(tuple(lines.Point(0, (1, 0, 0), (float(k), 0.0, 0.0), k in exact)
                                for k in range(count)))

    def test_a_dragged_point_takes_the_stroke_along(self):
        """A dragged point bends the stroke on either side over the length of its move, here 2 units; ends and
        pins stay."""
        line = self.line(20, exact=(8, 10))
        to = lines.Point(0, (1, 0, 0), (10.0, 2.0, 0.0), True)
        found = [point.position[:2] for point in lines.bent(line, 10, to).points]
        expected = [(float(k), 0.0) for k in range(9)] + [(10.0, 2.0)] + [(float(k), 0.0) for k in range(13, 20)]
        self.assertEqual(found, expected)
        far = lines.Point(0, (1, 0, 0), (10.0, 50.0, 0.0), True)
        self.assertEqual([p.position[0] for p in lines.bent(line, 10, far).points], [0, 8, 10, 19])

    def test_where_a_point_of_the_result_belongs(self):
        line = self.line(5)
        along = np.stack([np.linspace(0, 4, 41), np.full(41, 0.1), np.zeros(41)], -1)
        self.assertEqual(lines.place_on(line, along, 15), 2)
        self.assertEqual(lines.place_on(line, along, 0), 1)
        self.assertEqual(lines.place_on(line, along, 39), 4)
        loop = lines.Line(tuple(lines.Point(0, (1, 0, 0), place, True) for place in
                                ((0., 0., 0.), (4., 0., 0.), (4., 4., 0.), (0., 4., 0.))), closed=True)
        around = np.array([(4, 2, 0), (4, 4, 0), (2, 4, 0), (0, 4, 0), (0, 2, 0), (0, 0, 0), (2, 0, 0), (4, 0, 0)])
        self.assertEqual(lines.place_on(loop, around, 6), 1)
        self.assertEqual(lines.place_on(loop, around, 0), 2)
        self.assertEqual(lines.place_on(loop, around, 4), 4)

    def test_a_line_that_comes_back_is_not_taken_for_its_other_stretch(self):
        """The same case as in tests/plugins/editing/curves_test.cpp."""
        there = [(k / 10, 0.0, 0.0) for k in range(21)]
        along = np.array(there + [(x, 0.01, 0.0) for x, _, _ in reversed(there)])
        places = (0.0, 0.0, 0.0), (1.0, 0.009, 0.0), (2.0, 0.005, 0.0), (1.2, 0.001, 0.0), (0.0, 0.01, 0.0)
        line = lines.Line(tuple(lines.Point(0, (1, 0, 0), place, True) for place in places))
        self.assertEqual([lines.place_on(line, along, segment) for segment in (5, 15, 24, 35)], [1, 2, 3, 4])

    def test_too_few_points(self):
        self.assertIsNone(lines.without(self.line(1), 0))
        triangle = self.line(3)._replace(closed=True)
        self.assertFalse(lines.without(triangle, 1).closed)


class Hand(unittest.TestCase):
    """Actions on the hills, seen from above; the curve object shows the library's result."""

    def setUp(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())
        self.view = from_above()
        self.open = []

    def tearDown(self):
        for one in self.open:
            one.close()

    def begin(self, curve=None, **how):
        made = drawn.Drawn(bpy.context, self.obj, curve, **how)
        self.open.append(made)
        self.work = made.work
        return made

    def click(self, x, y, alone=False):
        self.assertTrue(self.work.press(self.view, pixel(x, y), alone))
        self.work.release(self.view, pixel(x, y))

    def drag(self, *places, alone=False):
        self.work.press(self.view, pixel(*places[0]), alone)
        for one, other in zip(places, places[1:]):
            for t in np.linspace(0, 1, 25)[1:]:
                self.work.move(self.view, pixel(*(np.array(one) * (1 - t) + np.array(other) * t)))
        self.work.release(self.view, pixel(*places[-1]))

    def positions(self):
        return [scene.spline_points_of(spline) for spline in curve_objects()[0].data.splines]

    def test_clicks_are_way_points(self):
        made = self.begin()
        clicks = [(10, 10), (30, 15), (50, 40)]
        for x, y in clicks:
            self.click(x, y)
        made.wait()
        self.assertEqual(made.error, "")
        points, = self.positions()
        for x, y in clicks:
            off = np.linalg.norm(points - np.array([x, y, hill(x, y)]), axis=1).min()
            self.assertLess(off, 0.05)
        self.assertEqual(len(self.work.editor.lines), 1)

    def test_a_stroke_is_a_line_of_its_own(self):
        made = self.begin()
        self.drag((10, 10), (20, 12), (30, 10))
        self.drag((10, 30), (30, 30))
        made.wait()
        self.assertEqual(len(self.positions()), 2)
        line = self.work.editor.lines[0]
        self.assertFalse(any(point.exact for point in line.points))
        np.testing.assert_allclose(line.points[0].position[:2], (10, 10), atol=1e-5)
        heights = line.positions
        np.testing.assert_allclose(heights[:, 2], hill(heights[:, 0], heights[:, 1]), atol=0.05)
        spacing = np.linalg.norm(np.diff(heights, axis=0), axis=1)
        self.assertGreater(spacing.min(), 0.3)

    def test_a_stroke_goes_on_from_clicks(self):
        self.begin()
        self.click(10, 10)
        self.click(20, 10)
        self.drag((22, 12), (30, 20))
        line, = self.work.editor.lines
        self.assertEqual([point.exact for point in line.points[:3]], [True, True, False])
        self.click(40, 20)
        self.assertTrue(self.work.editor.lines[0].points[-1].exact)
        self.work.next_line()
        self.click(10, 50)
        self.assertEqual(len(self.work.editor.lines), 2)

    def test_a_click_on_the_first_point_closes(self):
        made = self.begin()
        for x, y in ((10, 10), (30, 10), (30, 30), (10, 30), (10.3, 10.3)):
            self.click(x, y)
        line, = self.work.editor.lines
        self.assertTrue(line.closed)
        self.assertEqual(len(line.points), 4)
        made.wait()
        self.assertTrue(curve_objects()[0].data.splines[0].use_cyclic_u)
        self.work.close()
        self.assertFalse(self.work.editor.lines[0].closed)

    def test_a_stroke_that_comes_back_closes(self):
        self.begin()
        self.drag((10, 10), (30, 10), (30, 30), (10, 30), (10, 10.5))
        self.assertTrue(self.work.editor.lines[0].closed)

    def test_dragging_a_point(self):
        made = self.begin()
        for x, y in ((10, 10), (30, 15), (50, 40)):
            self.click(x, y)
        made.wait()
        self.drag((30, 15), (32, 25))
        made.wait()
        points, = self.positions()
        self.assertLess(np.linalg.norm(points - [32, 25, hill(32, 25)], axis=1).min(), 0.05)
        self.assertGreater(np.linalg.norm(points - [30, 15, hill(30, 15)], axis=1).min(), 1)
        self.work.undo()  # the whole drag is one step
        np.testing.assert_allclose(self.work.editor.lines[0].points[1].position[:2], (30, 15), atol=1e-5)
        self.work.redo()
        np.testing.assert_allclose(self.work.editor.lines[0].points[1].position[:2], (32, 25), atol=1e-5)

    def test_a_stroke_is_pinned_and_dragged_anywhere(self):
        made = self.begin()
        self.drag((10, 10), (50, 10))
        made.wait()
        before = len(self.work.editor.lines[0].points)
        points, = self.positions()
        at = points[len(points) // 2, :2]
        self.drag(at, (30, 14))
        made.wait()
        line, = self.work.editor.lines
        self.assertEqual(sum(point.exact for point in line.points), 1)
        self.assertLess(len(line.points), before)
        points, = self.positions()
        self.assertLess(np.linalg.norm(points - [30, 14, hill(30, 14)], axis=1).min(), 0.05)
        self.work.pin(self.view, pixel(30, 14))  # the second time removes the pin
        self.assertFalse(any(point.exact for point in self.work.editor.lines[0].points))

    def test_points_behind_the_mesh_are_not_seen(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.torus())
        made = self.begin()
        ground = self.work.ground
        above, below = (ground.nearest((3, 0, z), True) for z in (1, -1))
        matrix = np.eye(4) / 5
        matrix[2, 2], matrix[3, 3] = -0.2, 1
        down = View(matrix, WIDTH, HEIGHT)
        self.assertTrue(ground.sees(down, above.position))
        self.assertFalse(ground.sees(down, below.position))
        made.drop()

    def test_the_other_side_of_a_coarse_mesh(self):
        """The mean edge of a cube is as long as the cube."""
        scene.empty()
        bpy.ops.mesh.primitive_cube_add(size=2)
        self.obj = bpy.context.object
        self.begin()
        ground = self.work.ground
        matrix = np.eye(4) / 5
        matrix[2, 2], matrix[3, 3] = -0.2, 1
        down = View(matrix, WIDTH, HEIGHT)
        for z, seen_now in ((1, True), (-1, False)):
            self.assertEqual(ground.sees(down, ground.nearest((0.3, 0.2, z), True).position), seen_now)

    def test_meshes_of_every_unit(self):
        for scale in (1e-2, 1e3):
            with self.subTest(scale):
                scene.empty()
                vertices, faces = support.hills()
                self.obj = scene.add_mesh(vertices * scale, faces)
                scaled = np.diag([1 / scale] * 3 + [1])
                self.view = View(from_above().matrix @ scaled, WIDTH, HEIGHT)
                made = self.begin()
                self.click(10, 10)
                self.click(30, 15)
                self.click(50, 40)
                self.work.next_line()
                self.drag((10, 50), (30, 52))
                made.wait()
                self.assertEqual(made.error, "")
                points = np.concatenate(self.positions()) / scale
                for x, y in ((10, 10), (30, 15), (50, 40), (10, 50)):
                    self.assertLess(np.linalg.norm(points - [x, y, hill(x, y)], axis=1).min(), 0.05)

    def test_wheel_and_undo_of_tau(self):
        made = self.begin()
        self.drag((10, 10), (30, 14), (50, 10))
        self.work.turn(2)
        self.assertEqual(self.work.editor.state.tau, 1.25 ** 2)
        made.wait()
        self.assertAlmostEqual(made.curve.talweg.tau, 1.5625, places=6)
        self.work.undo()
        self.assertEqual(self.work.editor.state.tau, 1)
        for _ in range(40):
            self.work.turn(-1)
        self.assertEqual(self.work.editor.state.tau, 0)
        self.work.turn(1)
        self.assertGreater(self.work.editor.state.tau, 0)

    def test_the_sidebar_changes_what_is_drawn(self):
        made = self.begin()
        self.drag((10, 10), (30, 14), (50, 10))
        made.wait()
        made.curve.talweg.tau = 4
        self.assertEqual(self.work.editor.state.tau, 4)
        made.wait()
        self.assertEqual(made.result.total.tau, 4)

    def test_the_sidebar_shows_what_is_drawn(self):
        """The panel shows the tool's curve, not an earlier one; its lengths begin with those of the mesh."""
        bpy.context.view_layer.objects.active = self.obj
        for number in range(2):
            made = self.begin()
            self.assertEqual(panel._last_curve(bpy.context), made.curve)
            edge = made.place.edge
            self.assertAlmostEqual(made.curve.talweg.slack, edge, places=5)
            self.click(10, 10 + number)
            self.click(30, 20 + number)
            self.click(50, 10 + number)
            made.wait()
            self.assertAlmostEqual(made.curve.talweg.slack, edge, places=5)  # a drawing of way-points uses no
                                                                             # slack
            self.assertAlmostEqual(made.curve.talweg.max_deviation, made.result.total.farthest,
                                   places=5)
            told, _ = made.finish(bpy.context)
            self.assertIn(resmoothing.numbers(bpy.context, made.curve), told)

    def test_enter_does_not_smooth_a_shown_result_again(self):
        made = self.begin()
        self.click(10, 10)
        self.click(30, 15)
        made.wait()
        with unittest.mock.patch.object(made.live, "ask") as ask:
            made.finish(bpy.context)
        ask.assert_not_called()
        self.assertTrue(scene.spline_points(curve_objects()[0]).size)

    def test_finished_it_is_the_drivers_curve_and_can_be_edited_tomorrow(self):
        made = self.begin()
        for x, y in ((10, 10), (30, 15), (50, 40)):
            self.click(x, y)
        self.drag((50, 40), (50, 42))
        told, warnings = made.finish(bpy.context)
        self.assertIn("Curve: Mesh curve", told)
        curve, = curve_objects()
        self.assertEqual(curve.parent, self.obj)
        before = scene.spline_points(curve)
        points = self.work.editor.lines[0].points
        session.forget()
        edited = self.begin(curve)
        self.assertEqual(self.work.editor.lines[0].points, points)
        edited.wait()
        np.testing.assert_array_equal(scene.spline_points(curve), before)
        self.drag((30, 15), (30, 25))
        edited.drop()  # Esc restores the curve
        np.testing.assert_array_equal(scene.spline_points(curve_objects()[0]), before)
        edited = self.begin(curve_objects()[0])
        self.drag((30, 15), (30, 25))
        edited.finish(bpy.context)
        self.assertEqual(len(curve_objects()), 1)
        self.assertFalse(np.array_equal(scene.spline_points(curve_objects()[0]), before))

    def test_a_curve_of_edges_can_be_edited(self):
        scene.select_edges(self.obj, support.staircase())
        bpy.ops.talweg.smooth_edges(tau=2)
        bpy.ops.object.mode_set(mode="OBJECT")
        before = scene.spline_points(curve_objects()[0])
        made = self.begin(curve_objects()[0])
        self.assertEqual(len(self.work.editor.lines[0].points), len(support.staircase()))
        made.wait()
        np.testing.assert_allclose(scene.spline_points(curve_objects()[0])[[0, -1]], before[[0, -1]], atol=1e-5)
        made.drop()
        np.testing.assert_array_equal(scene.spline_points(curve_objects()[0]), before)

    def test_dropped_there_is_nothing(self):
        made = self.begin()
        self.drag((10, 10), (50, 10))
        made.drop()
        self.assertEqual(curve_objects(), [])
        self.assertEqual(len(bpy.data.curves), 0)

    def test_outcomes(self):
        made = self.begin(output="SEAM")
        self.drag((10, 10), (50, 12))
        made.finish(bpy.context)
        self.assertEqual(curve_objects(), [])
        self.assertTrue(any(edge.use_seam for edge in self.obj.data.edges))
        self.obj.modifiers.new("Fine", "SUBSURF")
        with self.assertRaisesRegex(talweg.BadUsage, "modifiers"):
            self.begin(output="SEAM")

    def test_on_modifiers(self):
        self.obj.modifiers.new("Fine", "SUBSURF").levels = 2
        made = self.begin()
        self.click(10.4, 10.3)
        self.click(30.2, 15.4)
        self.click(50.1, 40)
        made.wait()
        points, = self.positions()
        shown = self.obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
        off = [np.linalg.norm(np.subtract(shown.closest_point_on_mesh(p.tolist())[1], p)) for p in points]
        self.assertLess(max(off), 1e-4)

    def test_nothing_is_no_curve(self):
        made = self.begin()
        self.click(10, 10)
        with self.assertRaisesRegex(talweg.BadCurve, "two points"):
            made.finish(bpy.context)

    def test_beside_the_mesh(self):
        self.begin()
        self.assertFalse(self.work.press(self.view, pixel(62, 62)))
        self.assertEqual(self.work.editor.lines, ())


class Threads(unittest.TestCase):
    def test_the_newest_request_wins(self):
        mesh = talweg.Mesh(*support.hills())
        live = Live(mesh)
        drawing = [talweg.Curve(vertices=support.staircase())]
        for tau in range(30):
            live.ask(Request(drawing, {"tau": tau}, tag=tau))
        answer = live.wait()
        self.assertEqual((answer.request.tag, answer.result.total.tau), (29, 29))
        self.assertIsNone(live.poll())
        live.ask(Request([talweg.Curve(vertices=[5, 900])], {}))
        self.assertIsInstance(live.wait().error, talweg.BadCurve)
        live.close()
        self.assertFalse(live._thread.is_alive())  # pylint: disable=protected-access

    def test_enter_does_not_wait_for_replaced_requests(self):
        slow = _Slow()
        live = Live(slow)
        live.ask(Request([], {}, tag="old"))
        self.assertTrue(slow.at_work.wait(10))
        live.ask(Request([], {}, tag="new"))
        slow.is_slow = False
        answer = live.wait()
        self.assertEqual((answer.request.tag, answer.result), ("new", "done"))
        self.assertTrue(slow.cancelled.is_set())
        live.close()


class _Slow:
    """A mesh with a workspace whose first run ends when it is cancelled, or after ten seconds."""

    def __init__(self):
        self.at_work, self.cancelled = threading.Event(), threading.Event()
        self.is_slow = True

    def workspace(self):
        return self

    def set_curves(self, curves):
        pass

    def smooth(self, **_):
        slow, _ = self.is_slow, self.at_work.set()
        if slow and self.cancelled.wait(10):
            raise talweg.Cancelled("Cancelled.")
        return "done"

    def cancel(self):
        self.cancelled.set()


class Icon(unittest.TestCase):
    def test_the_icon_is_that_of_the_script(self):
        source = Path(support.SOURCE) / "plugins/hosts/blender/make_icon.py"
        made = runpy.run_path(str(source))["icon"]()
        self.assertEqual(Path(tool._ICON).with_suffix(".draw.dat").read_bytes(), made)
        self.assertGreater(bpy.app.icons.new_triangles_from_file(str(tool._ICON) + ".dat"), 0)
