"""Looks and place of results, warnings about drawings away from the mesh, and errors that name the cause."""

import contextlib
import io
import json
import unittest
from types import SimpleNamespace

import bpy
import numpy as np
from mathutils import Matrix
from talweg_blender import curve_object, lengths, marks, operators, operators_of_meshes, panel, \
    parameters, resmoothing, sentences, session

import scene
import support


def curve_objects():
    return [o for o in bpy.data.objects if o.type == "CURVE"]


def hill(x, y):
    return 3 * np.sin(x / 7) * np.cos(y / 5)


def line(y, off=0.0):
    x = np.linspace(5, 50, 60)
    return np.stack([x, np.full(60, float(y)), hill(x, y) + off], -1)


class Results(unittest.TestCase):
    def setUp(self):
        scene.empty()
        self.obj = scene.add_mesh(*support.hills())

    def smooth(self, operator=bpy.ops.talweg.smooth_annotations, **how):
        """Smooths, and returns the printed reports."""
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            self.assertEqual(operator(**how), {"FINISHED"})
        self.printed = printed.getvalue()
        return session.last_result()


class Seen(Results):
    def test_width_colour_and_place(self):
        """The width is between a 450th and a 150th of the mesh's size, in every unit."""
        for scale in (1e-2, 1, 1e3):
            with self.subTest(scale):
                scene.empty()
                vertices, faces = support.hills()
                self.obj = scene.add_mesh(vertices * scale, faces)
                scene.annotate([line(10) * scale])
                self.smooth()
                shown, = curve_objects()
                size = np.linalg.norm(np.ptp(vertices, axis=0)) * scale
                self.assertGreater(shown.data.bevel_depth, size / 451)
                self.assertLess(shown.data.bevel_depth, size / 149)
                self.assertTrue(shown.show_in_front)
                material, = shown.data.materials
                red, green, blue = material.diffuse_color[:3]
                self.assertGreater(min(red, blue), 4 * green)  # magenta
                self.assertEqual(shown.color[:], material.diffuse_color[:])

    def test_width_of_a_coarse_mesh(self):
        """The mean edge of a cube is larger than its side."""
        cube = SimpleNamespace(edge=2.28, size=12**0.5)
        self.assertAlmostEqual(curve_object.radius(cube, 1), 12**0.5 / 150)
        self.assertAlmostEqual(curve_object.radius(cube, 0.5), 12**0.5 / 300)

    def test_the_sidebar_says_that_cuts_are_without_modifiers(self):
        said = []
        layout = SimpleNamespace(label=lambda text, icon="": said.append(text), operator=lambda *_, **__: None)
        panel._of_mesh(layout, self.obj)
        self.assertNotIn("Cuts are without modifiers", said)
        self.obj.modifiers.new("Wave", "WAVE")
        panel._of_mesh(layout, self.obj)
        self.assertIn("Cuts are without modifiers", said)
        panel._of_edges(layout, self.obj)
        self.assertIn("Without modifiers", said)

    def test_large_numbers_have_no_exponent(self):
        self.assertEqual([lengths.number(value, 2) for value in (7.24, 32.4, 99.7, 450.4)], ["7.2", "32", "100", "450"])
        self.assertEqual([lengths.number(value) for value in (0.01234, 1234.5, 1e12, np.inf)],
                         ["0.0123", "1234", "1e+12", "inf"])

    def test_lengths_in_mean_edges(self):
        slider = parameters.annotations()["slack_in_edges"].keywords
        self.assertEqual(slider["soft_max"], 10)
        operator = SimpleNamespace(slack=6.0, mean_edge=3.0)
        self.assertEqual(slider["get"](operator), 2)
        slider["set"](operator, 4)
        self.assertEqual(operator.slack, 12)

    def test_words_fit_into_the_panel(self):
        of_meshes = [one for each in operators_of_meshes._properties().values() for one in each.items()]
        for name, made in [*parameters.annotations().items(), *operators._STROKES.items(), *of_meshes]:
            words = made.keywords
            if not name.startswith("use_"):  # a box has no text field
                self.assertLess(len(words.get("name", "")), 18, name)
            for item in words.get("items", ()):
                self.assertLess(len(item[1]), 16, name)
            self.assertNotIn("equation", str(words))
        bound = operators_of_meshes._properties()[operators_of_meshes.TALWEG_OT_material_borders]["max_deviation"]
        self.assertEqual(bound.keywords["unit"], "LENGTH")  # of meshes of every unit

    def test_rounding_is_no_curvature(self):
        scene.annotate([line(10)])
        self.smooth(tau=0)
        report = json.loads(curve_objects()[0]["talweg_report"])
        report.update(curvature_after=4.8e-15, bending_after=7e-30)
        printed = sentences.of_report(bpy.context, report)
        self.assertIn(f"Curvature {report['curvature_before']:.3g} to 0 rad", printed)
        self.assertIn(" to 0, ", printed)


class Places(Results):
    def test_it_follows_the_mesh(self):
        """The curve follows its mesh through shear, too, which only a child can have."""
        parent = bpy.data.objects.new("Parent", None)
        bpy.context.scene.collection.objects.link(parent)
        parent.scale = (1, 3, 1)
        self.obj.parent = parent
        self.obj.rotation_euler = (0, 0, 0.5)
        bpy.context.view_layer.update()
        matrix = np.array(self.obj.matrix_world)
        scene.annotate([line(10) @ matrix[:3, :3].T])
        self.smooth()
        self.assertIn("scaled unevenly", self.printed)
        shown, = curve_objects()
        self.assertEqual(shown.matrix_world, self.obj.matrix_world)
        self.obj.location.x += 7
        bpy.context.view_layer.update()
        self.assertEqual(shown.matrix_world, self.obj.matrix_world)

    def test_a_mirror_is_no_uneven_scale(self):
        self.obj.scale = (-2, 2, 2)
        bpy.context.view_layer.update()
        scene.annotate([line(10) * [-2, 2, 2]])
        self.smooth()
        self.assertNotIn("unevenly", self.printed)

    def test_the_same_drawing_has_one_object(self):
        scene.annotate([line(10), line(30)])
        self.smooth(tau=1)
        shown, = curve_objects()
        shown.name = "Mine"
        own = bpy.data.materials.new("Mine")
        shown.data.materials[0] = own
        shown.hide_set(True)
        result = self.smooth(tau=4)
        self.assertEqual([o.name for o in curve_objects()], ["Mine"])
        self.assertEqual(len(bpy.data.curves), 1)
        self.assertTrue(shown.visible_get())
        self.assertEqual(shown.data.materials[:], [own])
        np.testing.assert_array_equal(scene.spline_points(shown, 1),
                                      result.curves[1].positions.astype(np.float32))
        self.smooth(strokes="1")
        self.assertEqual(len(curve_objects()), 2)
        row = [10 * 60 + k for k in range(5, 55)]
        for tau in (1, 2):
            scene.select_edges(self.obj, row)
            self.smooth(bpy.ops.talweg.smooth_edges, tau=tau)
            self.assertEqual(len(curve_objects()), 3)

    def test_it_lies_on_the_mesh_with_its_modifiers(self):
        """The mesh is cast to a sphere: points of the plain cube would be up to 0.39 off."""
        scene.empty()
        bpy.ops.mesh.primitive_cube_add(size=2)
        self.obj = bpy.context.object
        self.obj.modifiers.new("Fine", "SUBSURF").levels = 4
        cast = self.obj.modifiers.new("Round", "CAST")
        cast.factor, cast.size, cast.use_radius_as_size = 1, 1, False
        t = np.linspace(0, 1.5, 40)
        scene.annotate([np.stack([np.cos(t), np.sin(t), 0.3 * np.sin(3 * t)], -1)
                        / np.sqrt(1 + 0.09 * np.sin(3 * t) ** 2)[:, None]])
        self.smooth()
        shown, = curve_objects()
        radii = np.linalg.norm(scene.spline_points(shown), axis=1)
        np.testing.assert_allclose(radii, 1, atol=0.01)

    def test_edges_of_a_modified_mesh(self):
        self.obj.modifiers.new("Fine", "SUBSURF")
        scene.select_edges(self.obj, support.staircase())
        self.smooth(bpy.ops.talweg.smooth_edges)
        self.assertIn("without its modifiers", self.printed)
        self.obj.modifiers[0].show_viewport = False
        self.smooth(bpy.ops.talweg.smooth_edges)
        self.assertNotIn("modifiers", self.printed)


class Astray(Results):
    def refused(self, words, operator=bpy.ops.talweg.smooth_annotations, **how):
        with self.assertRaises(RuntimeError) as caught:
            operator(**how)
        for one in words:
            self.assertIn(one, str(caught.exception))

    def test_rounding_is_not_worth_a_word(self):
        scene.annotate([line(10)])
        mesh, _ = support.hills()
        rounded = mesh[:60].astype(np.float32)
        scene.annotate([rounded + np.float32(1e-6)])
        self.smooth()
        self.assertNotIn("moved onto", self.printed)
        self.assertNotIn("Warning", self.printed)
        self.assertIn("Curvature", self.printed)

    def test_far_is_a_warning_behind_the_numbers(self):
        """The box of the hills has a diagonal of 83.7: far is 2.8, a thirtieth; too far is 10.5."""
        scene.annotate([line(10, 3.5)])
        self.smooth()
        warning, = [one for one in self.printed.splitlines() if one.startswith("Warning")]
        self.assertLess(warning.index("Curvature"), warning.index("Stroke 0 was drawn up to"))
        self.assertIn("Placement to Surface", warning)
        scene.annotate([line(10, 0.5)])
        self.smooth()
        self.assertNotIn("Stroke 0", self.printed)

    def test_each_value_is_measured_once(self):
        asked = []

        def measure():
            asked.append(1)
            return 0.5

        session.forget()
        for move, what, times in ((0, "a", 1), (0, "a", 1), (0, "b", 2), (1, "a", 3), (-1, "a", 3)):
            self.obj.data.vertices[0].co.x += move
            place = session.surface_of(bpy.context, self.obj, True)
            self.assertEqual(place.measured(what, measure), 0.5)
            self.assertEqual(len(asked), times)
        session.forget()

    def test_too_far_is_refused(self):
        scene.annotate([line(10, 40)])
        self.refused(["Stroke 0 lies up to 38.6 m away from the mesh", "mean edges", "Placement to Surface"])
        self.assertEqual(curve_objects(), [])

    def test_strokes_astray_do_not_stop_the_others(self):
        bad = line(20)
        bad[7, 1] = np.nan
        data = scene.annotate([line(10), line(15, 40), bad, line(25)[:1], line(30), line(40)])
        data.layers[0].frames[0].strokes[5].display_mode = "SCREEN"
        result = self.smooth()
        self.assertEqual(len(result.curves), 2)
        np.testing.assert_allclose(result.curves[1].positions[0], line(30)[0], atol=0.1)
        for words in ("Left out: Stroke 1 lies", "Stroke 2 has a coordinate", "Stroke 3 has 1 point",
                      "1 more"):
            self.assertIn(words, self.printed)

    def test_chosen_strokes(self):
        scene.annotate([line(y) for y in (10, 20, 30, 40)])
        for chosen, ys in (("", [10, 20, 30, 40]), ("1", [20]), ("0, 2-3", [10, 30, 40]),
                           ("-1", [40]), ("3 3 0", [10, 40])):
            with self.subTest(chosen):
                result = self.smooth(strokes=chosen)
                starts = [curve.positions[0][1] for curve in result.curves]
                np.testing.assert_allclose(starts, ys, atol=0.1)
        self.refused(["'one' is not a number or range"], strokes="one")
        for wrong in ("4", "2-7", "-5"):
            self.refused(["there is no stroke"], strokes=wrong)
        self.refused(["'3-1' is not a number or range"], strokes="3-1")

    def test_errors_and_warnings_name_the_curve_object(self):
        for name, positions in (("Good", line(10)), ("Bad", [[1, 1, 0], [np.nan, 5, 0]])):
            scene_curve(name, positions)
        self.refused(["Bad: ", "not finite"], bpy.ops.talweg.cut)
        bpy.data.objects.remove(bpy.data.objects["Good"])
        self.refused(["Bad: ", "not finite"], bpy.ops.talweg.cut)
        bpy.data.objects.remove(bpy.data.objects["Bad"])
        scene_curve("Above", line(10, 3.5))
        self.smooth(bpy.ops.talweg.cut)
        self.assertIn("cut. Above lies up to", self.printed)


def u_turn():
    """A stroke of 75 samples along y = 20, and back four units beside it."""
    way = np.r_[[(10 + t, 20) for t in range(31)], [(40, 20 + t) for t in range(1, 5)],
                [(40 - t, 24) for t in range(1, 31)]].astype(float)
    return np.c_[way, hill(*way.T)]


class Layout:
    """A layout that records the content of a panel in order."""

    def __init__(self, parts):
        self.__dict__["parts"] = parts

    def __getattr__(self, name):
        def put(*given, **named):
            self.parts.append((name, *given, *named.values()))
            return Layout(self.parts)
        return put


class Decisive(Results):
    """Decisive warnings stand before the fields, and are marked in the view."""

    def panel_of(self, curve):
        bpy.context.view_layer.objects.active = curve
        parts = []
        panel.VIEW3D_PT_talweg.draw(SimpleNamespace(layout=Layout(parts)), bpy.context)
        return [(part[0], part[1]) for part in parts if part[0] in ("label", "prop")]

    def test_a_part_that_is_cut_off(self):
        scene.annotate([u_turn()])
        self.smooth(use_slack=True, slack=8)
        curve, = curve_objects()
        self.assertEqual(resmoothing.icon(curve), "ERROR")
        kind, words = self.panel_of(curve)[0]
        self.assertEqual(kind, "label")
        self.assertTrue(words.startswith("Mesh curve: The result cuts"), words)
        bpy.context.view_layer.objects.active = self.obj
        of_mesh = []
        panel.VIEW3D_PT_talweg.draw(SimpleNamespace(layout=Layout(of_mesh)), bpy.context)
        self.assertIn(words, [part[1] for part in of_mesh if part[0] == "label"][:1])
        place, = marks.places(curve)
        self.assertLess(np.linalg.norm(u_turn() - place, axis=1).min(), 0.5)
        self.assertGreater(place[0], 35)  # at its bend
        flat = np.diag([1 / 60, 1 / 60, 0, 1])  # the camera far above, with 60 units to the right edge
        ring, = marks.rings([curve], flat, 240, 240)
        np.testing.assert_allclose(ring.mean(axis=0), (place[:2] / 60 + 1) * 120, atol=1)
        np.testing.assert_allclose(np.linalg.norm(ring - (place[:2] / 60 + 1) * 120, axis=1), 13, atol=1e-3)

    def test_a_loop_that_collapses(self):
        turn = np.linspace(0, 2 * np.pi, 30, endpoint=False)
        x, y = 30 + 2 * np.cos(turn), 30 + 2 * np.sin(turn)
        scene.annotate([np.c_[x, y, hill(x, y)]])
        self.smooth(tau=0, ends="closed")
        curve, = curve_objects()
        self.assertEqual(resmoothing.icon(curve), "ERROR")
        lines = sentences.decisive_of(curve_object.report_of(curve))
        self.assertTrue(any("shrinks to a point" in line for line in lines), lines)
        self.assertEqual(len(marks.places(curve)), len(lines) - 1)  # a collapse has no place

    def test_a_curve_as_it_was_meant(self):
        scene.annotate([line(10)])
        self.smooth()
        curve, = curve_objects()
        self.assertEqual(resmoothing.icon(curve), "CURVE_DATA")
        self.assertEqual(self.panel_of(curve)[0][0], "prop")
        self.assertEqual(len(marks.places(curve)), 0)
        self.assertEqual(marks.rings([curve], np.eye(4), 240, 240), [])


def scene_curve(name, positions):
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("POLY")
    spline.points.add(len(positions) - 1)
    spline.points.foreach_set("co", np.c_[positions, np.ones(len(positions))].ravel())
    obj = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)


class Matrices(unittest.TestCase):
    def test_shear_and_mirrors(self):
        plain = SimpleNamespace(name="Mesh", data=SimpleNamespace(shape_keys=None), modifiers=())
        for matrix, uneven in ((Matrix.Identity(4), False), (Matrix.Diagonal((1, -1, 1, 1)), False),
                               (Matrix.Rotation(0.3, 4, "X") @ Matrix.Scale(7, 4), False),
                               (Matrix.Diagonal((1, 1, 1.01, 1)), True),
                               (Matrix.Shear("XY", 4, (0.1, 0)), True)):
            plain.matrix_world = matrix
            self.assertEqual(len(sentences.of_object(plain, True)), uneven)
