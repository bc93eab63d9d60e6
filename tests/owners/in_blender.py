"""In Blender: writes the mesh of for-blender.npz by all exporters whose formats Talweg reads."""

import os
import sys

import bpy
import numpy as np

folder = sys.argv[sys.argv.index("--") + 1]


def at(name):
    return os.path.join(folder, name)


arrays = np.load(at("for-blender.npz"))
bpy.ops.wm.read_factory_settings(use_empty=True)
mesh = bpy.data.meshes.new("bump")
mesh.from_pydata(arrays["vertices"].tolist(), [], arrays["faces"].tolist())
shape = bpy.data.objects.new("bump", mesh)
bpy.context.collection.objects.link(shape)
bpy.context.view_layer.objects.active = shape
shape.select_set(True)

bpy.ops.export_scene.gltf(filepath=at("blender-flat.glb"))  # a vertex for each corner
mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
bpy.ops.export_scene.gltf(filepath=at("blender.glb"))
bpy.ops.export_scene.gltf(filepath=at("blender-separate.gltf"), export_format="GLTF_SEPARATE")
bpy.ops.export_scene.gltf(filepath=at("blender-embedded.gltf"), export_format="GLTF_EMBEDDED")
bpy.ops.export_scene.gltf(filepath=at("blender-z-up.glb"), export_yup=False)
bpy.ops.wm.obj_export(filepath=at("blender-y-up.obj"))
bpy.ops.wm.obj_export(filepath=at("blender.obj"), forward_axis="Y", up_axis="Z")
bpy.ops.export_mesh.ply(filepath=at("blender.ply"))
bpy.ops.export_mesh.ply(filepath=at("blender-text.ply"), use_ascii=True)
bpy.ops.export_mesh.stl(filepath=at("blender.stl"))
bpy.ops.export_mesh.stl(filepath=at("blender-text.stl"), ascii=True)
