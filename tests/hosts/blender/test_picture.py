"""From a file to a rendered picture: a generated figure, a drawing along its edges, and the smoothed curve;
and the pieces of a textured mesh."""

import os
import subprocess
import unittest
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector
from talweg_blender import session

import scene
import support
import test_pieces

FOLDER = Path(os.environ["TALWEG_PICTURE_FOLDER"])
WIDTH, HEIGHT = 600, 366
SAMPLES = int(os.environ.get("TALWEG_PICTURE_SAMPLES", 4))  # 16 for the pictures of the pages


def material(name, colour, roughness=0.6):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = roughness
    return made


def look_at(target, towards, distance, roll=0.0):
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    bpy.context.scene.collection.objects.link(camera)
    camera.location = target + distance * towards.normalized()
    camera.rotation_euler = (-towards).to_track_quat("-Z", "Y").to_euler()
    camera.rotation_euler.rotate_axis("Z", roll)
    bpy.context.scene.camera = camera
    return camera


def add_sun(towards, strength, shadow=True):
    light = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    light.data.energy = strength
    light.data.cycles.cast_shadow = shadow
    light.data.angle = 0  # sharp shadows need no samples
    light.rotation_euler = (-Vector(towards)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(light)


def render(path):
    """Renders with Cycles on the processor, without a display or graphics card. Returns the pixels, (h, w,
    3)."""
    settings = bpy.context.scene
    settings.render.engine = "CYCLES"
    settings.cycles.device = "CPU"
    settings.cycles.samples = SAMPLES
    settings.cycles.use_denoising = False
    settings.cycles.max_bounces = 0
    settings.view_settings.view_transform = "Standard"
    settings.render.resolution_x, settings.render.resolution_y = WIDTH, HEIGHT
    settings.render.resolution_percentage = 100
    settings.render.dither_intensity = 0
    settings.render.image_settings.file_format = "PNG"
    settings.render.image_settings.color_mode = "RGB"
    settings.render.image_settings.compression = 100
    settings.render.filepath = str(path)
    world = bpy.data.worlds.new("World")
    world.color = (0.95, 0.95, 0.95)
    world.cycles_visibility.diffuse = world.cycles_visibility.glossy = False  # only the background
    settings.world = world
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    return np.array(image.pixels[:]).reshape(HEIGHT, WIDTH, -1)[:, :, :3]


class Picture(unittest.TestCase):
    def setUp(self):
        scene.empty()

    def drawn_on_figure(self):
        if not os.environ["TALWEG_SCENES"]:
            self.skipTest("no talweg-scenes (TALWEG_BUILD_DEMO)")
        subprocess.run([os.environ["TALWEG_SCENES"], str(FOLDER)], check=True, capture_output=True)
        through = (FOLDER / "figure.through").read_text().split()
        support.driver(FOLDER, "draw", "figure.ply", *through, "-o", "drawn.txt")
        drawn = np.loadtxt(FOLDER / "drawn.txt", dtype=int)
        return drawn[:-1] if drawn[0] == drawn[-1] else drawn, drawn[0] == drawn[-1]

    def test_picture(self):
        drawn, closed = self.drawn_on_figure()
        bpy.ops.import_mesh.ply(filepath=str(FOLDER / "figure.ply"))
        figure = bpy.context.object
        scene.select_edges(figure, drawn, closed)
        size = max(figure.dimensions)
        self.assertEqual(bpy.ops.talweg.smooth_edges(tau=2), {"FINISHED"})
        result = session.last_result()
        self.assertLess(result.total.curvature_after, result.total.curvature_before / 5)
        smooth = next(o for o in bpy.data.objects if o.type == "CURVE")

        bpy.ops.object.mode_set(mode="OBJECT")
        xyz = scene.vertices_of(figure)[drawn]
        jagged = bpy.data.curves.new("Drawn", "CURVE")
        jagged.dimensions, jagged.bevel_depth = "3D", size / 500
        spline = jagged.splines.new("POLY")
        spline.points.add(len(xyz) - 1)
        spline.points.foreach_set("co", np.c_[xyz, np.ones(len(xyz))].astype(np.float32).ravel())
        spline.use_cyclic_u = closed
        jagged = bpy.data.objects.new("Drawn", jagged)
        bpy.context.scene.collection.objects.link(jagged)

        figure.data.materials.append(material("Clay", (0.55, 0.5, 0.45)))
        jagged.data.materials.append(material("Red", (0.7, 0.01, 0.01)))
        smooth.data.materials[0] = material("Blue", (0.01, 0.06, 0.7))
        figure.data.polygons.foreach_set("use_smooth", np.ones(len(figure.data.polygons), bool))
        self.frame(figure, xyz)
        pixels = render(FOLDER / "blender.png")

        red, green, blue = np.moveaxis(pixels, -1, 0)
        self.assertGreater(np.count_nonzero((blue > 2 * red) & (blue > 0.25)), 500)
        self.assertGreater(np.count_nonzero((red > 2 * blue) & (red > 2 * green)), 300)
        self.assertGreater(np.std(green), 0.05)

    def test_texture_of_pieces(self):
        """docs/pictures/blender_pieces.png: the texture continues across the gap."""
        pieces = test_pieces.textured_pieces()
        self.assertEqual(len(pieces), 2)
        together = self.render_pieces("together.png")
        upper = max(pieces, key=lambda piece: scene.vertices_of(piece)[:, 1].mean())
        upper.location.y += 4
        apart = self.render_pieces("blender_pieces.png")
        background = (apart > 0.94).all(axis=-1)
        self.assertGreater(np.count_nonzero(background[100:280, 100:400]), 3000)  # the gap
        scene.empty()
        test_pieces.textured()
        whole = self.render_pieces("whole.png")
        self.assertLess(np.abs(together - whole).mean(), 0.01)

    def render_pieces(self, name):
        for obj in [o for o in bpy.data.objects if o.type in ("LIGHT", "CAMERA")]:
            bpy.data.objects.remove(obj)
        look_at(Vector((29, 29, 0)), Vector((0.2, -0.5, 1)), 95)
        add_sun((0.5, 0.3, 1), 3)
        return render(FOLDER / name)

    def frame(self, figure, xyz):
        """Camera and lights: the drawing from outside, upright."""
        xyz = xyz.astype(float)
        centre = xyz.mean(axis=0)
        normals = np.array([figure.data.vertices[v].normal for v in
                            np.argsort(((scene.vertices_of(figure) - centre) ** 2).sum(1))[:200]])
        towards = Vector(normals.mean(axis=0))
        distance = 2.3 * float(np.linalg.norm(xyz - centre, axis=1).max())
        look_at(Vector(centre), towards, distance)
        add_sun(towards * 0.6 + Vector((0, 0, 1)).cross(towards), 2.2)
        # A light from the other side, without shadows.
        add_sun(towards - Vector((0, 0, 1)).cross(towards) * 0.5, 1.0, shadow=False)
