"""Surfaces that are kept from one call to the next, and whether they are still those of their objects."""

import bpy
import numpy as np

from .drawings import MeshArrays
from .surface import Surface

#: So many surfaces, or triangles of all together; the oldest go first, the last one stays.
_MOST, _MOST_TRIANGLES = 8, 3_000_000


class _Kept:
    surfaces: list = []
    unchanged: dict = {}  # by pointers of object and mesh, and whether as shown
    result = None
    watched: list = []


def forget():
    """Frees what was kept."""
    _Kept.surfaces, _Kept.unchanged, _Kept.result = [], {}, None


def last_result():
    """The talweg.Result of the last call, in double precision; None if there was none."""
    return _Kept.result


def is_changed(obj):
    """Whether the surface that is shown may be another one than the mesh."""
    return obj.data.shape_keys is not None or any(one.show_viewport for one in obj.modifiers)


def surface_of(context, obj, as_shown, trust=False):
    """The Surface of an object: with modifiers and shape keys as it is shown, or the mesh itself.

    :param trust: nothing is read where Blender has told of no change since the last time. Of what
        scripts write into arrays it tells only after ``mesh.update()``.
    :raises talweg.BadMesh: if there are no faces.
    """
    context.view_layer.update()  # tells of what has changed
    evaluated = None  # what is hidden is not evaluated
    if obj.mode == "OBJECT" and obj.visible_get() and (as_shown or not is_changed(obj)):
        evaluated = obj.evaluated_get(context.evaluated_depsgraph_get())
    key = obj.as_pointer(), obj.data.as_pointer(), evaluated is not None
    found = _Kept.unchanged.get(key) if trust else None
    if found is None:
        if obj.mode == "EDIT":
            obj.update_from_editmode()
            context.view_layer.update()  # it tells of this as of a change
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
    """A surface with these arrays, the one that is there if there is one."""
    found = next((one for one in _Kept.surfaces if _is_same(one.arrays, arrays)), None)
    if found is None:
        found = Surface(arrays)
    _Kept.surfaces = [one for one in _Kept.surfaces if one is not found][1 - _MOST:] + [found]
    while len(_Kept.surfaces) > 1 and sum(one.triangle_count for one in _Kept.surfaces) > _MOST_TRIANGLES:
        _Kept.surfaces.pop(0)
    _Kept.unchanged = {key: one for key, one in _Kept.unchanged.items() if one in _Kept.surfaces}
    found.arrays = arrays  # polygons may be others though the triangles are the same
    return found


def _is_same(kept, arrays):
    return (np.array_equal(kept.vertices, arrays.vertices)
            and np.array_equal(kept.triangles, arrays.triangles))


def smooth(surface, curves, parameters, **how):
    """As Surface.smooth(); last_result() gives it again."""
    _Kept.result = None
    _Kept.result = surface.smooth(curves, parameters, **how)
    return _Kept.result


class Watched:
    """Whether Blender has told of a change of an object's mesh, or taken a step back, since it was made.

    After that the object may be no more, and must not be touched."""

    def __init__(self, context, obj):
        context.view_layer.update()  # tells of what has changed before
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
    """Objects are other ones now, if they are there at all."""
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
