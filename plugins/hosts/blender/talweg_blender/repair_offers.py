"""The offer to repair a refused mesh, and the places that show it."""

import bpy

from . import wrapped
from .package import talweg


class _Last:
    object = ""  # the object's name; empty: there is no offer
    sentence = ""
    operator = ""


def forget(obj=None):
    """Removes the offer for this object; without an object, any offer."""
    if obj is None or obj.name == _Last.object:
        _Last.object = ""


def is_for(obj):
    return obj is not None and obj.name == _Last.object


def _steps(place):
    """The steps of a repair that makes the mesh a surface, in words; empty if there is none."""
    found = talweg.inspect((place.arrays.vertices, place.arrays.triangles))
    return found["repair_steps"].replace(",", ", ") if found["verdict"] == "repairable" else ""


def note(obj, place, error, operator):
    """Keeps an offer to repair the mesh, if a repair would help. Returns the error's sentence, with the offer
    if there is one."""
    steps = _steps(place)
    if not steps:
        return str(error)
    _Last.object, _Last.operator = obj.name, operator
    _Last.sentence = str(error)
    return (f"{error} The mesh can be repaired ({steps}): use Repair for Talweg, or tick "
            "On a repaired copy.")


def draw(layout, obj, width=None):
    """Draws the offer for the object in a panel or at the mouse pointer."""
    if not is_for(obj):
        return
    box = layout.box() if width is None else layout  # a box in a menu would be indented
    box.operator_context = "INVOKE_DEFAULT"
    wrapped.draw(box, [_Last.sentence], width)
    if _Last.operator:
        box.operator(_Last.operator, text="Smooth on a Repaired Copy").repair = True
    box.operator("talweg.repair", text="Repair the Mesh")


def popup(context, obj):
    """Shows the offer in a menu at the mouse pointer."""
    if not bpy.app.background and is_for(obj):
        context.window_manager.popup_menu(lambda menu, _: draw(menu.layout, obj, 60), title="Talweg")
