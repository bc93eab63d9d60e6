"""Results as curve objects."""

import json

import bpy
import numpy as np

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
            "bending_before": r.bending_before, "bending_after": r.bending_after,
            "window_turning_after": r.window_turning_after,
            "deviation_to_drawn_max": r.deviation_to_drawn_max, "termination": r.termination}


def add(obj, result, thickness):
    """A new curve object of the result, in the place of `obj`."""
    made = bpy.data.objects.new(obj.name + " curve", _data_of(result, thickness))
    (obj.users_collection or (bpy.context.scene.collection,))[0].objects.link(made)
    made.matrix_world = obj.matrix_world.copy()
    made["talweg_report"] = json.dumps(_report_of(result))
    return made
