"""Curves coloured by a number along them. A second object, with a spline for each colour, covers the plain
curve.

The only colour of a curve object that every shading of Blender 3.4 shows is the material of a spline.
"""

from itertools import groupby

import bpy
import numpy as np

from .package import talweg

_COUNT = 9
_NAME = "Talweg colour"
_WIDER = 1.7  # times the plain curve's width, so that the coloured curve covers it


def wanted_fields(settings):
    """The fields that Surface.smooth() has to compute for the colours."""
    return {"point_fields": True} if settings.colours != "PLAIN" else {}


def show(curve, settings, result, bevel, surface):
    """Makes, replaces or removes the coloured object of a curve object. The panel reads the range of the
    values from the property ``talweg_range`` of the curve object."""
    made = _existing(curve)
    if settings.colours == "PLAIN":
        if made is not None:
            remove(curve)
        curve.pop("talweg_range", None)
        return
    values = [_values(one, settings.colours, surface.edge) for one in result.curves]
    most = max((float(each.max()) for each in values if len(each)), default=0.0)
    curve["talweg_range"] = most
    made = made or _new(curve)
    made.data.bevel_depth = bevel * _WIDER
    made.data.splines.clear()
    for one, each in zip(result.curves, values):
        classes = np.minimum((each / (most or 1) * _COUNT).astype(int), _COUNT - 1)
        _write(made.data, one, classes.tolist())


def remove(curve):
    """Removes the coloured object of a curve object."""
    made = _existing(curve)
    if made is not None:
        data = made.data
        bpy.data.objects.remove(made)
        if not data.users:
            bpy.data.curves.remove(data)


def _existing(curve):
    return next((one for one in curve.children if one.get("talweg_colours")), None)


def _values(curve, what, edge):
    """The number to be coloured, for each segment of the curve."""
    if what == "DEVIATION":
        at = np.asarray(curve.fields["deviation"])
        at = np.r_[at, at[:1]] if curve.closed else at
        return np.maximum(at[:-1], at[1:])
    return _turning(curve, edge)


def _turning(curve, edge):
    """Turning per unit of length, radians, in windows of two mean edges: a polyline turns only at its points,
    so that turning has no value at a single place."""
    points = np.asarray(curve.positions)
    points = np.vstack([points, points[:1]]) if curve.closed else points
    at = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    turns = talweg._turning.Turns(at[:-1] if curve.closed else at, np.asarray(curve.fields["curvature"]),
                                  float(at[-1]), curve.closed)
    if not at[-1] > 0:
        return np.zeros(len(at) - 1)
    steps, values = turns.curvature_along(min(2 * edge, at[-1]))
    middle = (at[:-1] + at[1:]) / 2
    return np.abs(values[np.clip(np.searchsorted(steps, middle) - 1, 0, len(values) - 1)])


def _write(data, curve, classes):
    points = np.column_stack([curve.positions, np.ones(len(curve))]).astype(np.float32)
    number = 0
    for colour, run in groupby(classes):
        count = len(list(run))
        spline = data.splines.new("POLY")
        spline.points.add(count)
        among = np.arange(number, number + count + 1) % len(points)
        spline.points.foreach_set("co", points[among].ravel())
        spline.material_index = colour
        number += count


def _new(curve):
    data = bpy.data.curves.new(curve.name + " colours", "CURVE")
    data.dimensions = "3D"
    data.bevel_resolution = 2
    data.use_fill_caps = True
    for number in range(_COUNT):
        data.materials.append(_material(number))
    made = bpy.data.objects.new(curve.name + " colours", data)
    for collection in curve.users_collection:
        collection.objects.link(made)
    made.parent = curve
    made.show_in_front = True
    made.hide_select = True
    made["talweg_colours"] = True
    return made


def _material(number):
    name = f"{_NAME} {number}"
    material = bpy.data.materials.get(name)
    if material is None or material.library is not None:
        shown = talweg._colors.ramp(np.array([number / (_COUNT - 1)]))[0]
        colour = (*np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4), 1)
        material = bpy.data.materials.new(name)
        material.diffuse_color = colour
        material.roughness, material.specular_intensity = 1, 0
        material.use_nodes = True
        material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = colour
    return material
