"""Scenes for the tests: meshes as objects, drawings as selections and annotations."""

import bmesh
import bpy
import numpy as np


def empty():
    if bpy.context.object is not None and bpy.context.object.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    for group in (bpy.data.objects, bpy.data.meshes, bpy.data.curves, bpy.data.grease_pencils):
        for item in list(group):
            group.remove(item)


def add_mesh(vertices, polygons, name="Mesh"):
    """Makes the active object of a mesh; its vertices are rounded to single precision."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.asarray(vertices).tolist(), [], np.asarray(polygons).tolist())
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    return obj


def select_edges(obj, path, closed=False):
    """Selects, in edit mode, the edges from each vertex of the path to the next."""
    bpy.context.view_layer.objects.active = obj
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="EDGE")
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(obj.data)
    bm.verts.ensure_lookup_table()
    path = [bm.verts[int(v)] for v in path]
    for a, b in zip(path, path[1:] + (path[:1] if closed else [])):
        bm.edges.get((a, b)).select_set(True)
    bmesh.update_edit_mesh(obj.data)


def annotate(strokes, mode="3DSPACE"):
    """Adds strokes of the annotation tool: lists of positions in the world."""
    data = bpy.data.grease_pencils.new("Annotations")
    bpy.context.scene.grease_pencil = data
    layer = data.layers.new("Note", set_active=True)
    frame = layer.frames.new(bpy.context.scene.frame_current)
    for positions in strokes:
        stroke = frame.strokes.new()
        stroke.display_mode = mode
        stroke.points.add(len(positions))
        stroke.points.foreach_set("co", np.asarray(positions, np.float32).ravel())
    return data


def vertices_of(obj):
    """The vertices in single precision, as Blender stores them."""
    values = np.empty((len(obj.data.vertices), 3), np.float32)
    obj.data.vertices.foreach_get("co", values.ravel())
    return values


def spline_points(curve_object, number=0):
    return spline_points_of(curve_object.data.splines[number])


def spline_points_of(spline):
    values = np.empty(4 * len(spline.points), np.float32)
    spline.points.foreach_get("co", values)
    return values.reshape(-1, 4)[:, :3]
