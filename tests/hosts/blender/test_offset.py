"""Offset curves of curve objects; expected lengths are computed by hand in the plane."""

import math
import unittest

import bpy
import numpy as np
from talweg_blender import last_report, session

import scene

N = 61


def sheet():
    """A flat square of 60 x 60 quads, seen from above."""
    i, k = np.meshgrid(np.arange(N), np.arange(N), indexing="ij")
    a = (i * N + k)[:-1, :-1].ravel()
    return scene.add_mesh(np.stack([i, k, 0 * i], -1).reshape(-1, 3),
                          np.stack([a, a + N, a + N + 1, a + 1], -1))


def line(ends):
    """A selected curve object, a straight line between two points."""
    data = bpy.data.curves.new("Line", "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("POLY")
    spline.points.add(1)
    spline.points.foreach_set("co", np.c_[np.asarray(ends, float), np.ones(2)].ravel())
    obj = bpy.data.objects.new("Line", data)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    return obj


def length_of(spline):
    points = scene.spline_points_of(spline).astype(float)
    if spline.use_cyclic_u:
        points = np.vstack([points, points[:1]])
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


class Offset(unittest.TestCase):
    def setUp(self):
        scene.empty()
        session.forget()
        self.obj = sheet()
        self.line = line([[20, 30, 0], [40, 30, 0]])

    def made(self):
        """The newest offset of the mesh."""
        return max((one for one in self.obj.children if " offset" in one.name), key=lambda one: one.name)

    def test_around_the_curve(self):
        self.assertEqual(bpy.ops.talweg.offset(distance=3), {"FINISHED"})
        spline, = self.made().data.splines
        self.assertTrue(spline.use_cyclic_u)
        self.assertAlmostEqual(length_of(spline), 2 * 20 + 6 * math.pi, delta=0.02)
        points = scene.spline_points_of(spline)
        ahead = np.clip(points[:, 0], 20, 40)
        np.testing.assert_allclose(np.hypot(points[:, 0] - ahead, points[:, 1] - 30), 3, atol=1e-5)
        self.assertRegex(last_report.of(self.obj)[0], "^1 curve at 3 m along the surface, length 58.8")

    def test_one_side_and_several_distances(self):
        self.assertEqual(bpy.ops.talweg.offset(distance=2, count=3, side="left"), {"FINISHED"})
        splines = self.made().data.splines
        self.assertEqual(len(splines), 3)
        for spline, y in zip(splines, (32, 34, 36)):  # left is +y, seen from above along +x
            points = scene.spline_points_of(spline)
            np.testing.assert_allclose(points[:, 1], y, atol=1e-5)
            np.testing.assert_allclose([points[0, 0], points[-1, 0]], [20, 40], atol=1e-5)

    def test_the_band_can_be_separated(self):
        self.assertEqual(bpy.ops.talweg.offset(distance=3), {"FINISHED"})
        self.line.select_set(False)
        self.made().select_set(True)
        self.assertEqual(bpy.ops.talweg.separate(), {"FINISHED"})
        areas = sorted(sum(polygon.area for polygon in one.data.polygons)
                       for one in bpy.data.objects if one.type == "MESH")
        self.assertEqual(len(areas), 2)
        self.assertAlmostEqual(areas[0], 20 * 6 + 9 * math.pi, delta=0.05)
        self.assertAlmostEqual(sum(areas), 3600, delta=0.01)

    def test_without_a_distance_it_is_three_edges(self):
        """The default distance suits meshes of any size: three mean edges, here of two sides of 1 and a
        diagonal."""
        self.assertEqual(bpy.ops.talweg.offset(), {"FINISHED"})
        reach = 3 * (2 + math.sqrt(2)) / 3
        points = scene.spline_points(self.made())
        self.assertAlmostEqual(points[:, 1].max(), 30 + reach, delta=1e-3)

    def test_of_an_active_curve(self):
        """An active smoothed curve is enough, since it has its mesh and the exact curve."""
        self.line.select_set(False)
        scene.select_edges(self.obj, [30 * N + k for k in range(20, 41)])
        bpy.ops.talweg.smooth_edges()
        bpy.ops.object.mode_set(mode="OBJECT")
        curve, = self.obj.children
        bpy.ops.object.select_all(action="DESELECT")
        curve.select_set(True)
        bpy.context.view_layer.objects.active = curve
        self.assertEqual(bpy.ops.talweg.offset(distance=3, caps="none"), {"FINISHED"})
        offset = self.made()
        self.assertEqual(offset.parent, self.obj)
        self.assertEqual([round(length_of(one), 3) for one in offset.data.splines], [20, 20])

    def test_bad_input_changes_nothing(self):
        before = len(bpy.data.objects)
        for words, how in (("No curve object is selected", {}), ("farthest", {"distance": 1000})):
            self.line.select_set(bool(how))
            with self.assertRaises(RuntimeError) as caught:
                bpy.ops.talweg.offset(**how)
            self.assertIn(words, str(caught.exception))
        self.assertEqual(len(bpy.data.objects), before)
