"""Results as curve objects."""

import hashlib
import json

import bpy
import numpy as np

KEY = "talweg_drawing"


def key_of(obj, curves):
    """Tells a drawing on an object from others, so that the redo panel changes the curve that is
    there instead of adding another one."""
    digest = hashlib.sha1(obj.name.encode())
    for curve in curves:
        points = curve.vertices if curve.vertices is not None else curve.positions
        digest.update(np.ascontiguousarray(points).tobytes())
    return digest.hexdigest()


def _data_of(result, thickness):
    data = bpy.data.curves.new("Talweg", "CURVE")
    data.dimensions = "3D"
    data.bevel_depth = thickness
    for curve in result.curves:
        spline = data.splines.new("POLY")
        spline.points.add(len(curve) - 1)
        points = np.column_stack([curve.positions, np.ones(len(curve))])
        spline.points.foreach_set("co", points.astype(np.float32).ravel())
        spline.use_cyclic_u = curve.closed
    return data


def _report_of(result):
    r = result.total
    return {"tau": r.tau, "slack": r.slack, "length_after": r.length_after,
            "curvature_before": r.curvature_before, "curvature_after": r.curvature_after,
            "deviation_to_drawn_max": r.deviation_to_drawn_max, "termination": r.termination}


def show(obj, key, result, thickness):
    """The curve object of this drawing, new or changed, in the place of `obj`."""
    data = _data_of(result, thickness)
    found = next((o for o in bpy.data.objects if o.type == "CURVE" and o.get(KEY) == key), None)
    if found is None:
        found = bpy.data.objects.new(obj.name + " curve", data)
        (obj.users_collection or (bpy.context.scene.collection,))[0].objects.link(found)
        found[KEY] = key
    else:
        old, found.data = found.data, data
        for material in old.materials:
            data.materials.append(material)
        if old.users == 0:
            bpy.data.curves.remove(old)
    found.matrix_world = obj.matrix_world.copy()
    found["talweg_report"] = json.dumps(_report_of(result))
    return found
