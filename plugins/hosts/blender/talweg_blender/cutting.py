"""Meshes cut, taken apart, labelled and repaired by Talweg, in objects."""

from contextlib import contextmanager

import bpy
import numpy as np

from . import attributes, objects, remade
from .package import talweg


@contextmanager
def object_mode(obj):
    """Meshes are replaced in object mode; what was edited is edited again after it."""
    mode = obj.mode
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode=mode)


def _saved(obj, arrays):
    """All that the mesh has besides its surface; raises talweg.Error if it must not be replaced."""
    objects.check(obj)
    if not len(arrays.triangles):
        raise talweg.BadMesh("The mesh has no faces.")
    with object_mode(obj):  # in edit mode Blender shows no values of attributes
        return attributes.Attributes(obj, arrays)


def _cutting(saved, arrays, curves, how):
    return lambda progress: saved.mesh(arrays, plugin="talweg.cut", progress=progress).cut(
        curves, progress=progress, **how)


def cut(obj, arrays, curves, mark=None, **how):
    """Curves become selected edges of the mesh. Steps of jobs; they return the talweg.Cut, and warnings.

    :param mark: "use_seam" or "use_edge_sharp": what these edges become besides.
    """
    saved = _saved(obj, arrays)
    made = yield _cutting(saved, arrays, curves, how)
    with object_mode(obj):
        place = remade.rewrite(obj, made.mesh, saved, arrays)[1]
        remade.select_chains(obj, made.mesh, place)
        if mark:
            marked = attributes.read(obj.data.edges, mark, 1, bool)
            attributes.write(obj.data.edges, mark, marked | attributes.read(obj.data.edges, "select", 1, bool))
    return made, objects.warnings(obj, saved.lost)


def of_report(made):
    """Warnings on a cut, without how far curves were moved: the drawing has told it where it mattered."""
    return [one for one in made.report["warnings"] if "moved onto the mesh" not in one]


def separate(obj, arrays, curves, **how):
    """An object for each piece, in the place of this one, which becomes the first of them.
    Steps of jobs; they return the objects, and warnings."""
    saved = _saved(obj, arrays)
    made = yield _cutting(saved, arrays, curves, {**how, "split": True})
    if not made.meshes:
        raise talweg.BadCurve("Nothing is left of the mesh on that side of the curves.")
    with object_mode(obj):
        if objects.others_with_mesh(obj):  # theirs stays whole
            obj.data = obj.data.copy()
        pieces = [obj] + [_copy(obj) for _ in made.meshes[1:]]
        for one, piece in zip(pieces, made.meshes):
            place = remade.rewrite(one, piece, saved, arrays)[1]
            remade.select_chains(one, piece, place)
            one.select_set(True)
    return pieces, [*objects.warnings(obj, saved.lost), *of_report(made)]


def _copy(obj):
    other = obj.copy()
    other.data = obj.data.copy()
    for collection in obj.users_collection or (bpy.context.scene.collection,):
        collection.objects.link(other)
    return other


def smooth_materials(obj, arrays, **how):
    """The borders between materials become smooth edges of the mesh. Steps of jobs; they return
    the talweg.Labels, and warnings."""
    saved = _saved(obj, arrays)
    materials = saved.at_faces["flag:material_index"][arrays.polygons]
    found = yield lambda progress: saved.mesh(arrays, plugin="talweg.labels", progress=progress).labels(
        materials, of="faces", progress=progress, **how)
    layout, place = remade.rewrite(obj, found.mesh, saved, arrays)
    attributes.write(obj.data.polygons, "material_index",
                     found.mesh.face_attributes["label"][layout.triangle_of].astype(np.int32))
    remade.select_chains(obj, found.mesh, place)
    obj.data.update()
    return found, objects.warnings(obj, saved.lost)


def smooth_group(obj, arrays, threshold, **how):
    """The border of the active vertex group becomes smooth edges of the mesh; vertices inside and on
    it have the weight 1, and others are no members any more. Steps of jobs;
    they return the talweg.Labels, and warnings."""
    number = obj.vertex_groups.active_index
    if not 0 <= number < len(obj.vertex_groups):
        raise talweg.BadUsage("The object has no vertex group.")
    saved = _saved(obj, arrays)
    inside = saved.at_vertices["groups"][:, number] >= threshold
    found = yield lambda progress: saved.mesh(arrays, plugin="talweg.labels", progress=progress).labels(
        inside.astype(np.int32), of="vertices", progress=progress, **how)
    made = found.mesh
    weights = made.vertex_attributes["groups"]
    weights[:, number] = 0
    weights[made.faces[made.face_attributes["label"] == 1].ravel(), number] = 1
    place = remade.rewrite(obj, made, saved, arrays)[1]
    remade.select_chains(obj, made, place)
    return found, objects.warnings(obj, saved.lost)


def repair(obj, arrays, steps):
    """Makes a surface of the mesh. Steps of jobs; they return the talweg.Repair, and warnings."""
    saved = _saved(obj, arrays)
    fixed = yield lambda progress: saved.mesh(arrays, plugin="talweg.repair", progress=progress).repair(
        steps, progress=progress)
    with object_mode(obj):
        remade.rewrite(obj, fixed.mesh, saved, arrays, fixed.became)
    return fixed, objects.warnings(obj, saved.lost)
