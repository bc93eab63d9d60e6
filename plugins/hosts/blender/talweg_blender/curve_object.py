"""Results as curve objects: children of the mesh's object, one for each drawing."""

import json

import bpy
import numpy as np

from . import colours, settings

_MATERIAL = "Talweg curve"
#: Unlike the blue of annotations and the orange of selected objects.
_COLOUR = (0.9, 0.0, 0.4, 1.0)


def radius(surface, thickness):
    """Radius of the bevel. With thickness 1 the curve is visible in a view of the whole mesh and of one
    face."""
    fitting = min(max(surface.edge / 5, surface.size / 450), surface.size / 150)
    return thickness * fitting


def _material():
    material = bpy.data.materials.get(_MATERIAL)
    if material is None or material.library is not None:
        material = bpy.data.materials.new(_MATERIAL)
        material.diffuse_color = _COLOUR  # the colour in the viewport
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
    """The report of the shown result, values by name; empty before the first result."""
    return json.loads(curve.get("talweg_report", "{}"))


def of_drawing(context, obj, key):
    """The curve object of the drawing ``key`` on this mesh, made visible; None if there is none."""
    for one in obj.children:
        if (one.type == "CURVE" and one.get("talweg_drawing") == key and one.library is None
                and one.data.library is None and one.name in context.view_layer.objects):
            one.hide_set(False)
            return one
    return None


def new(context, obj, word="curve"):
    """An empty curve object, a child of the mesh's object.

    :param word: the end of the name, after the name of the mesh's object.
    """
    data = bpy.data.curves.new("Talweg", "CURVE")
    data.dimensions = "3D"
    data.bevel_resolution = 2
    data.use_fill_caps = True
    data.materials.append(_material())
    made = bpy.data.objects.new(f"{obj.name} {word}", data)
    _collection(context, obj).objects.link(made)
    made.parent = obj  # its own matrix is the identity, so that it follows shear, too
    made.color = _COLOUR
    number(made)
    made.show_in_front = True
    return made


def number(curve):
    """Numbers the curve as the newest of its mesh."""
    curve["talweg_number"] = 1 + max(one.get("talweg_number", 0) for one in curve.parent.children)


def _collection(context, obj):
    """The collection of the mesh's object; the scene's if the former belongs to another file."""
    own = [one for one in obj.users_collection if one.library is None]
    return own[0] if own else context.scene.collection


def write_lines(curve, surface, result):
    """Writes the curves of a result to an object that has no drawing."""
    _write(curve.data, result, radius(surface, 1))


def write(curve, surface, result):
    """Writes a result to its object, with the width and the colours of the object's settings."""
    kept = settings.of(curve)
    bevel = radius(surface, kept.thickness)
    _write(curve.data, result, bevel)
    colours.show(curve, kept, result, bevel, surface)
    curve["talweg_report"] = json.dumps(_report_of(result))


def put(context, obj, place, drawing, result, operator, as_shown):
    """Puts a result into the curve object of its drawing, which is made if it does not exist.

    :param operator: has the values of the parameters.
    """
    made = of_drawing(context, obj, drawing.key) or new(context, obj)
    made["talweg_drawing"] = drawing.key
    number(made)
    settings.keep(made, operator, result.drawn, place, as_shown)
    write(made, place, result)
    context.view_layer.update()
    return made
