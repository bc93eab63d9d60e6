"""Keeps polygons whose triangulation by Blender is a surface."""

import bpy
import numpy as np


def without_repetitions(made, touched, parts, single):
    """Replaces parts (polygons.Part) by their triangles where Blender's triangulation would repeat a triangle
    or an oriented edge of another part.

    Two polygons on either side of a nearly straight line may both get a triangle along it. Such a mesh would
    not be a surface and could not be cut again.

    :param touched: the triangles of ``made`` that the parts consist of.
    :param single: a function that makes single triangles of a part.
    """
    while any(len(part.corners) > 3 for part in parts):
        bad = _repeating(made, touched, parts)
        if not bad.any():
            break
        parts = [one for part, is_bad in zip(parts, bad) for one in
                 (single(part.triangles, part.polygon) if is_bad else [part])]
    return parts


def _repeating(made, touched, parts):
    """(number of parts,): whether an oriented edge of the part's triangles occurs twice."""
    triangles, of_part = _as_blender_does(made, parts)
    marked = np.zeros(len(made.vertices), bool)
    marked[triangles.ravel()] = True
    near = marked[made.faces].sum(axis=1) > 1
    near[touched] = False
    n = len(made.vertices)
    all_of_them = np.concatenate([triangles, made.faces[near]])
    keys = all_of_them * n + np.roll(all_of_them, -1, axis=1)
    _, number, times = np.unique(keys.ravel(), return_inverse=True, return_counts=True)
    twice = (times[number] > 1).reshape(-1, 3).any(axis=1)[:len(triangles)]
    result = np.zeros(len(parts), bool)
    result[of_part[twice]] = True
    return result & [len(part.corners) > 3 for part in parts]


def _as_blender_does(made, parts):
    """Blender's triangles of the parts, as vertices of ``made``, and the part of each triangle."""
    totals = np.array([len(part.corners) for part in parts], np.int32)
    corners = np.concatenate([part.corners for part in parts])
    vertices, loops = np.unique(made.faces.ravel()[corners], return_inverse=True)
    mesh = bpy.data.meshes.new("Talweg")
    try:
        mesh.vertices.add(len(vertices))
        mesh.vertices.foreach_set("co", made.vertices[vertices].astype(np.float32).ravel())
        mesh.loops.add(len(loops))
        mesh.loops.foreach_set("vertex_index", loops.astype(np.int32))
        mesh.polygons.add(len(totals))
        mesh.polygons.foreach_set("loop_start", (np.cumsum(totals) - totals).astype(np.int32))
        mesh.polygons.foreach_set("loop_total", totals)
        mesh.update(calc_edges=True)
        mesh.calc_loop_triangles()
        triangles = np.empty((len(mesh.loop_triangles), 3), np.int32)
        mesh.loop_triangles.foreach_get("vertices", triangles.ravel())
        of_part = np.empty(len(triangles), np.int32)
        mesh.loop_triangles.foreach_get("polygon_index", of_part)
    finally:
        bpy.data.meshes.remove(mesh)
    return vertices[triangles].astype(np.int64), of_part
