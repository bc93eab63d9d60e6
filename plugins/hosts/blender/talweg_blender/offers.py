"""A mesh that is refused but can be repaired: what is offered, and where it can be read."""

import bpy

from . import wrapped
from .package import talweg


class _Last:
    object = ""  # its name; empty: nothing is offered
    sentence = ""
    operator = ""


def forget(obj=None):
    """What is offered for this object, or at all."""
    if obj is None or obj.name == _Last.object:
        _Last.object = ""


def is_for(obj):
    return obj is not None and obj.name == _Last.object


def _steps(place):
    """Of a repair that makes a surface of it, in words; empty: there is none."""
    told = talweg.inspect((place.arrays.vertices, place.arrays.triangles))
    return told["repair_steps"].replace(",", ", ") if told["verdict"] == "repairable" else ""


def note(obj, place, error, operator):
    """The sentence with what can be done; the same as it is where that is nothing."""
    steps = _steps(place)
    if not steps:
        return str(error)
    _Last.object, _Last.operator = obj.name, operator
    _Last.sentence = str(error)
    return (f"{error} That can be repaired ({steps}): use Repair for Talweg, or tick "
            "On a repaired copy.")


def draw(layout, obj, width=None):
    """In a panel or at the pointer, if there is something to offer for the object."""
    if not is_for(obj):
        return
    box = layout.box() if width is None else layout  # a menu would indent it
    box.operator_context = "INVOKE_DEFAULT"
    wrapped.draw(box, [_Last.sentence], width)
    if _Last.operator:
        box.operator(_Last.operator, text="Smooth on a Repaired Copy").repair = True
    box.operator("talweg.repair", text="Repair the Mesh")


def popup(context, obj):
    """At the pointer."""
    if not bpy.app.background and is_for(obj):
        context.window_manager.popup_menu(lambda menu, _: draw(menu.layout, obj, 60), title="Talweg")
