"""The report of the last change of a mesh, for the sidebar: Blender may take longer to draw a changed mesh
than the status bar shows the report."""

import bpy

from . import wrapped


class _Last:
    object = ""  # the object's name; empty: there is no report
    done = ""
    warnings = ()


def note(name, done, warnings):
    """Keeps the report of a change of the object with this name."""
    _Last.object, _Last.done, _Last.warnings = name, done, tuple(warnings)


def of(obj):
    """The sentence and the warnings of the report; empty if it belongs to another object."""
    return (_Last.done, _Last.warnings) if obj is not None and obj.name == _Last.object else ("", ())


def draw(layout, obj):
    done, warnings = of(obj)
    wrapped.draw(layout, [done] if done else [], icon="INFO")
    wrapped.draw(layout, warnings)


@bpy.app.handlers.persistent
def _forget(*_):
    _Last.object = ""


def register():
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.load_post):
        handlers.append(_forget)


def unregister():
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.load_post):
        handlers.remove(_forget)
    _forget()
