"""Replaces the mesh of an object by the result of a cut, a separation, smoothed borders of labels, or a
repair."""

from contextlib import contextmanager

import bpy
import numpy as np

from . import attributes, objects, replace_mesh
from .package import talweg


@contextmanager
def object_mode(obj):
    """A context in object mode, where meshes can be replaced. Edit mode is restored at the end."""
    mode = obj.mode
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode=mode)


def _saved(obj, arrays):
    """All data of the mesh besides its surface; raises talweg.Error if the mesh must not be replaced."""
    objects.check(obj)
    if not len(arrays.triangles):
        raise talweg.BadMesh("The mesh has no faces.")
    with object_mode(obj):  # Blender has no values of attributes in edit mode
        return attributes.Attributes(obj, arrays)


def _cutting(saved, arrays, curves, how):
    return lambda progress: saved.mesh(arrays, plugin="talweg.cut", progress=progress).cut(
        curves, progress=progress, **how)


def cut(obj, arrays, curves, mark=None, **how):
    """Cuts the curves into the mesh and selects their edges. Steps as in jobs.py; they return the talweg.Cut,
    and warnings.

    :param mark: "use_seam" or "use_edge_sharp": a mark for the edges of the curves; None: no mark.
    """
    saved = _saved(obj, arrays)
    made = yield _cutting(saved, arrays, curves, how)
    with object_mode(obj):
        place = replace_mesh.rewrite(obj, made.mesh, saved, arrays)[1]
        replace_mesh.select_chains(obj, made.mesh, place)
        if mark:
            marked = attributes.read(obj.data.edges, mark, 1, bool)
            attributes.write(obj.data.edges, mark, marked | attributes.read(obj.data.edges, "select", 1, bool))
    return made, objects.warnings(obj, saved.lost)


def of_report(made):
    """Warnings of a cut. The distances that points of the curves were moved are left out: a warning of the
    drawing has them where they are large."""
    return [one for one in made.report["warnings"] if "moved onto the mesh" not in one]


def separate(obj, arrays, curves, **how):
    """Makes an object of each piece. The first piece replaces the mesh of ``obj``. Steps as in jobs.py; they
    return the objects, and warnings."""
    saved = _saved(obj, arrays)
    made = yield _cutting(saved, arrays, curves, {**how, "split": True})
    if not made.meshes:
        raise talweg.BadCurve("Nothing is left of the mesh on that side of the curves.")
    with object_mode(obj):
        if objects.others_with_mesh(obj):  # the other objects keep the whole mesh
            obj.data = obj.data.copy()
        pieces = [obj] + [_copy(obj) for _ in made.meshes[1:]]
        for one, piece in zip(pieces, made.meshes):
            place = replace_mesh.rewrite(one, piece, saved, arrays)[1]
            replace_mesh.select_chains(one, piece, place)
            one.select_set(True)
    return pieces, [*objects.warnings(obj, saved.lost), *of_report(made)]


def _copy(obj):
    other = obj.copy()
    other.data = obj.data.copy()
    for collection in obj.users_collection or (bpy.context.scene.collection,):
        collection.objects.link(other)
    return other


def smooth_materials(obj, arrays, **how):
    """Smooths the borders between materials and cuts them into the mesh. Steps as in jobs.py; they return the
    talweg.Labels, and warnings."""
    saved = _saved(obj, arrays)
    materials = saved.at_faces["flag:material_index"][arrays.polygons]
    found = yield lambda progress: saved.mesh(arrays, plugin="talweg.labels", progress=progress).labels(
        materials, of="faces", progress=progress, **how)
    layout, place = replace_mesh.rewrite(obj, found.mesh, saved, arrays)
    attributes.write(obj.data.polygons, "material_index",
                     found.mesh.face_attributes["label"][layout.triangle_of].astype(np.int32))
    replace_mesh.select_chains(obj, found.mesh, place)
    obj.data.update()
    return found, objects.warnings(obj, saved.lost)


def smooth_group(obj, arrays, threshold, **how):
    """Smooths the border of the active vertex group and cuts it into the mesh. Vertices inside and on the
    border get the weight 1; all other vertices leave the group. Steps as in jobs.py; they return the
    talweg.Labels, and warnings."""
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
    place = replace_mesh.rewrite(obj, made, saved, arrays)[1]
    replace_mesh.select_chains(obj, made, place)
    return found, objects.warnings(obj, saved.lost)


def repair(obj, arrays, steps):
    """Repairs the mesh, so that it becomes a surface. Steps as in jobs.py; they return the talweg.Repair, and
    warnings."""
    saved = _saved(obj, arrays)
    fixed = yield lambda progress: saved.mesh(arrays, plugin="talweg.repair", progress=progress).repair(
        steps, progress=progress)
    with object_mode(obj):
        replace_mesh.rewrite(obj, fixed.mesh, saved, arrays, fixed.became)
    return fixed, objects.warnings(obj, saved.lost)
