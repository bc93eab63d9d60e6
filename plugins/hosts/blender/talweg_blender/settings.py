"""The drawing and the values of a curve object, stored on it, so that a user can change the values later."""

import contextlib
import json

import bpy
import numpy as np

from . import parameters
from .package import talweg

#: Functions (context, curve) that are called after a user has changed a value. The add-on's other modules add
#: them.
changed_by_hand = []

_quiet = []


@contextlib.contextmanager
def quietly():
    """A context in which set values do not count as changes by the user."""
    _quiet.append(True)
    try:
        yield
    finally:
        _quiet.pop()


def _changed(settings, context):
    if not _quiet:
        for function in changed_by_hand:
            function(context, settings.id_data)


class TALWEG_PG_settings(bpy.types.PropertyGroup):
    """The values of a curve object. A change of a value smooths the drawing of the object again."""


def own(changed):
    """Properties that are not parameters of the plugin."""
    update = {"update": changed} if changed else {}
    return {
        "thickness": bpy.props.FloatProperty(
            name="Thickness", default=1, min=0, soft_max=4, precision=2, step=10,
            description="Thickness of the curve object; 1 fits the edges and the size of the mesh", **update),
        "colours": bpy.props.EnumProperty(
            name="Colours", default="PLAIN", description="The values that the colours of the curve show", **update,
            items=[("PLAIN", "Plain", "The colour of its material"),
                   ("DEVIATION", "Deviation", "Distance from what was drawn, along the surface"),
                   ("TURNING", "Turning", "How sharply the curve turns on the surface")]),
        "repair": bpy.props.BoolProperty(
            name="On a repaired copy", default=False, description="Smooth on a repaired copy of a mesh "
            "that is not a surface; the mesh itself stays as it is", **update),
    }


def draw_own(layout, values):
    """Draws the fields of the properties of own()."""
    for name in ("thickness", "colours"):
        layout.prop(values, name)
    row = layout.row()
    row.use_property_split = False
    row.prop(values, "repair")


def of(curve):
    return curve.talweg


def is_kept(obj):
    """Whether the object is a curve object with a stored drawing and a mesh."""
    return (obj is not None and obj.type == "CURVE" and "talweg_drawn" in obj
            and obj.parent is not None and obj.parent.type == "MESH")


def keep(curve, source, drawn, surface, as_shown):
    """Stores the drawing and its values on the curve object.

    :param source: an operator or settings with the values; None: the values stay.
    :param drawn: talweg.Curves.
    """
    settings = of(curve)
    with quietly():
        if source is not None and source != settings:
            parameters.copy(source, settings)
            for name in own(None):
                setattr(settings, name, getattr(source, name, getattr(settings, name)))
        settings.mean_edge = surface.edge
        settings.as_shown = as_shown
    curve["talweg_drawn"] = json.dumps({
        "mesh": surface.fingerprint, "curves": [_written(one, surface.arrays) for one in drawn]})


def _written(curve, arrays):
    """The curve as JSON. Positions are stored, too, for a mesh that changes later."""
    found = {"closed": bool(curve.closed)}
    if curve.vertices is not None and np.all(np.asarray(curve.vertices) >= 0):
        found["vertices"] = np.asarray(curve.vertices).tolist()
        positions = arrays.vertices[np.asarray(curve.vertices)]
    elif curve.faces is not None:
        found["faces"] = np.asarray(curve.faces).tolist()
        found["barycentrics"] = np.asarray(curve.barycentrics).tolist()
        corners = arrays.vertices[arrays.triangles[np.asarray(curve.faces)]].astype(float)
        positions = (corners * np.asarray(curve.barycentrics)[..., None]).sum(axis=1)
    else:
        positions = np.asarray(curve.positions, float)
    found["positions"] = positions.astype(float).tolist()
    marks = talweg._curves.marks(curve)
    if marks is not None:
        found["exact"] = marks.tolist()
    return found


def drawn_on(curve, surface):
    """The talweg.Curves of the drawing; if the mesh has changed, from the stored positions.

    :raises talweg.BadCurve: if the positions are far from the changed mesh.
    """
    kept = json.loads(curve["talweg_drawn"])
    same = kept["mesh"] == surface.fingerprint
    return [_read(one, same, surface, curve.name) for one in kept["curves"]]


def _read(one, same, surface, name):
    exact = np.array(one["exact"]) if "exact" in one else None
    if same and "vertices" in one:
        return talweg.Curve(vertices=one["vertices"], closed=one["closed"], exact=exact)
    if same and "faces" in one:
        return talweg.Curve(faces=one["faces"], barycentrics=one["barycentrics"], closed=one["closed"],
                            exact=exact)
    positions = np.array(one["positions"], float).reshape(-1, 3)
    if not same:
        distance = surface.farthest(positions)
        if distance > surface.too_far:
            raise talweg.BadCurve(f"The mesh of {name} has changed: its drawing lies "
                                  f"{surface.distance_text(distance)}.")
    return talweg.Curve(positions=positions, closed=one["closed"], exact=exact)


def register():
    TALWEG_PG_settings.__annotations__ = {
        **parameters.annotations(_changed), **own(_changed),
        "mean_edge": bpy.props.FloatProperty(options={"HIDDEN"}),
        "as_shown": bpy.props.BoolProperty(options={"HIDDEN"})}
    bpy.utils.register_class(TALWEG_PG_settings)
    bpy.types.Object.talweg = bpy.props.PointerProperty(type=TALWEG_PG_settings)


def unregister():
    del bpy.types.Object.talweg
    bpy.utils.unregister_class(TALWEG_PG_settings)
