"""What the last button did to a mesh, for the sidebar: while Blender draws a changed mesh anew, the
time is up for which the status bar shows it."""

import bpy

from . import wrapped


class _Last:
    object = ""  # its name; empty: nothing is told
    done = ""
    warnings = ()


def note(name, done, warnings):
    """Of the object with this name."""
    _Last.object, _Last.done, _Last.warnings = name, done, tuple(warnings)


def of(obj):
    """What was done, and warnings; nothing of other objects."""
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
