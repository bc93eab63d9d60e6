"""Surfaces that are kept between calls, and the check whether they still equal the meshes of their
objects."""

import bpy
import numpy as np

from .drawings import MeshArrays
from .surface import Surface

#: Limits of the kept surfaces: their number, and their triangles in total. The oldest are dropped first; the
#: newest always stays.
_MOST, _MOST_TRIANGLES = 8, 3_000_000


class _Kept:
    surfaces: list = []
    unchanged: dict = {}  # surfaces by (pointer of the object, of the mesh, as shown), until Blender reports
                          # a change
    result = None
    watched: list = []


def forget():
    """Drops all kept surfaces and the last result."""
    _Kept.surfaces, _Kept.unchanged, _Kept.result = [], {}, None


def last_result():
    """The talweg.Result of the last call, in double precision; None if the call failed or there was none."""
    return _Kept.result


def is_changed(obj):
    """Whether modifiers or shape keys may make the shown surface differ from the mesh."""
    return obj.data.shape_keys is not None or any(one.show_viewport for one in obj.modifiers)


def surface_of(context, obj, as_shown, trust=False):
    """The Surface of an object: as it is shown, with modifiers and shape keys, or of the mesh itself.

    :param trust: do not read the mesh if Blender has reported no change since the last call. Blender reports
        a change of arrays by a script only after ``mesh.update()``.
    :raises talweg.BadMesh: if the mesh has no faces.
    """
    context.view_layer.update()  # makes Blender report pending changes
    evaluated = None  # hidden objects are not evaluated
    if obj.mode == "OBJECT" and obj.visible_get() and (as_shown or not is_changed(obj)):
        evaluated = obj.evaluated_get(context.evaluated_depsgraph_get())
    key = obj.as_pointer(), obj.data.as_pointer(), evaluated is not None
    found = _Kept.unchanged.get(key) if trust else None
    if found is None:
        if obj.mode == "EDIT":
            obj.update_from_editmode()
            context.view_layer.update()  # Blender reports the evaluation as a change
        found = _kept(_read(obj, evaluated))
    _Kept.unchanged[key] = found
    found.shown = evaluated
    return found


def _read(obj, evaluated):
    if evaluated is None or not is_changed(obj):
        return MeshArrays(obj.data)
    arrays = MeshArrays(evaluated.to_mesh())
    evaluated.to_mesh_clear()
    return arrays


def _kept(arrays):
    """The kept surface with equal arrays; if there is none, a new one."""
    found = next((one for one in _Kept.surfaces if _is_same(one.arrays, arrays)), None)
    if found is None:
        found = Surface(arrays)
    _Kept.surfaces = [one for one in _Kept.surfaces if one is not found][1 - _MOST:] + [found]
    while len(_Kept.surfaces) > 1 and sum(one.triangle_count for one in _Kept.surfaces) > _MOST_TRIANGLES:
        _Kept.surfaces.pop(0)
    _Kept.unchanged = {key: one for key, one in _Kept.unchanged.items() if one in _Kept.surfaces}
    found.arrays = arrays  # the polygons may differ though the triangles are equal
    return found


def _is_same(kept, arrays):
    return (np.array_equal(kept.vertices, arrays.vertices)
            and np.array_equal(kept.triangles, arrays.triangles))


def smooth(surface, curves, parameters, **how):
    """Smooths as Surface.smooth() does; last_result() returns the result afterwards."""
    _Kept.result = None
    _Kept.result = surface.smooth(curves, parameters, **how)
    return _Kept.result


class Watched:
    """Notes whether Blender has reported a change of an object's mesh, or an undo, since the note was made.

    After a change the object may be gone and must not be touched."""

    def __init__(self, context, obj):
        context.view_layer.update()  # makes Blender report earlier changes first
        self.has_changed = False
        self._pointers = {obj.as_pointer(), obj.data.as_pointer()}
        _Kept.watched.append(self)

    def note(self, changed):
        self.has_changed |= bool(self._pointers & changed)

    def end(self):
        if self in _Kept.watched:
            _Kept.watched.remove(self)


@bpy.app.handlers.persistent
def _note(_scene, depsgraph=None):
    if depsgraph is None or not _Kept.unchanged and not _Kept.watched:
        return
    changed = {update.id.original.as_pointer() for update in depsgraph.updates
               if update.is_updated_geometry}
    for one in _Kept.watched:
        one.note(changed)
    _Kept.unchanged = {key: one for key, one in _Kept.unchanged.items() if not changed & set(key[:2])}


@bpy.app.handlers.persistent
def _doubt(*_):
    _Kept.unchanged = {}


@bpy.app.handlers.persistent
def _others(*_):
    """After an undo all objects are new, or gone."""
    _doubt()
    for one in _Kept.watched:
        one.has_changed = True


_HANDLERS = (("depsgraph_update_post", _note), ("frame_change_post", _doubt), ("undo_post", _others),
             ("redo_post", _others), ("load_post", _others))


def register():
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).append(function)


def unregister():
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(function)
    forget()
