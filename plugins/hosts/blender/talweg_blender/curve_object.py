"""Results as curve objects: children of the mesh's object, one for each drawing."""

import json

import bpy
import numpy as np

from . import colours, settings

_MATERIAL = "Talweg curve"
#: Neither an annotation's blue nor the orange of what is selected.
_COLOUR = (0.9, 0.0, 0.4, 1.0)


def radius(surface, thickness):
    """Of the bevel: 1 can be seen whether the whole mesh is looked at or one of its faces."""
    fitting = min(max(surface.edge / 5, surface.size / 450), surface.size / 150)
    return thickness * fitting


def _material():
    material = bpy.data.materials.get(_MATERIAL)
    if material is None or material.library is not None:
        material = bpy.data.materials.new(_MATERIAL)
        material.diffuse_color = _COLOUR  # of the viewport
        material.roughness, material.specular_intensity = 1, 0
        material.use_nodes = True
        material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = _COLOUR
    return material


def _write(data, result, bevel):
    data.bevel_depth = bevel
    data.splines.clear()
    for curve in result.curves:
        spline = data.splines.new("POLY")
        spline.points.add(len(curve) - 1)
        points = np.column_stack([curve.positions, np.ones(len(curve))])
        spline.points.foreach_set("co", points.astype(np.float32).ravel())
        spline.use_cyclic_u = curve.closed


def _report_of(result):
    r = result.total
    return {"tau": r.tau, "slack": r.slack, "length_after": r.length_after,
            "curvature_before": r.curvature_before, "curvature_after": r.curvature_after,
            "bending_before": r.bending_before, "bending_after": r.bending_after,
            "window_turning_after": r.window_turning_after,
            "deviation_to_drawn_max": r.deviation_to_drawn_max, "farthest": r.farthest,
            "farthest_at_most": r.farthest_at_most, "termination": r.termination,
            "warnings": list(r.warnings), "decisive": list(r.decisive), "decisive_at": list(r.decisive_at)}


def report_of(curve):
    """By the names of the report; empty where nothing is smoothed yet."""
    return json.loads(curve.get("talweg_report", "{}"))


def of_drawing(context, obj, key):
    """The object of the same drawing on this mesh, shown again; None if there is none."""
    for one in obj.children:
        if (one.type == "CURVE" and one.get("talweg_drawing") == key and one.library is None
                and one.data.library is None and one.name in context.view_layer.objects):
            one.hide_set(False)
            return one
    return None


def new(context, obj, word="curve"):
    """An empty one, a child of the mesh's object.

    :param word: follows the name of that object.
    """
    data = bpy.data.curves.new("Talweg", "CURVE")
    data.dimensions = "3D"
    data.bevel_resolution = 2
    data.use_fill_caps = True
    data.materials.append(_material())
    made = bpy.data.objects.new(f"{obj.name} {word}", data)
    _collection(context, obj).objects.link(made)
    made.parent = obj  # and no matrix of its own: it follows whatever the mesh does, shear too
    made.color = _COLOUR
    number(made)
    made.show_in_front = True
    return made


def number(curve):
    """It is the last one of its mesh now."""
    curve["talweg_number"] = 1 + max(one.get("talweg_number", 0) for one in curve.parent.children)


def _collection(context, obj):
    """That of the mesh's object, unless it belongs to another file."""
    own = [one for one in obj.users_collection if one.library is None]
    return own[0] if own else context.scene.collection


def write_lines(curve, surface, result):
    """The curves of a result in an object that is no drawing."""
    _write(curve.data, result, radius(surface, 1))


def write(curve, surface, result):
    """The result in its object, as wide and coloured as its settings say."""
    kept = settings.of(curve)
    bevel = radius(surface, kept.thickness)
    _write(curve.data, result, bevel)
    colours.show(curve, kept, result, bevel, surface)
    curve["talweg_report"] = json.dumps(_report_of(result))


def put(context, obj, place, drawing, result, operator, as_shown):
    """The curve object of the result of a drawing: a new one, or the one that it had.

    :param operator: has the values that the result was made with.
    """
    made = of_drawing(context, obj, drawing.key) or new(context, obj)
    made["talweg_drawing"] = drawing.key
    number(made)
    settings.keep(made, operator, result.drawn, place, as_shown)
    write(made, place, result)
    context.view_layer.update()
    return made
