"""Rings in the view around the places of decisive warnings, such as a missed way-point or a part that was cut
off."""

import bpy
import gpu
import numpy as np

from . import curve_object
from .drawing_tool import overlay
from .drawing_tool.view import View

_RED, _RIM = (0.9, 0.05, 0.05, 1), (1, 1, 1, 0.9)
_RADIUS = 13  # pixels
_TURN = np.linspace(0, 2 * np.pi, 33)


def places(curve):
    """(n, 3), the places of the decisive warnings in the space of the curve object."""
    found = np.array(curve_object.report_of(curve).get("decisive_at", ()), float).reshape(-1, 3)
    return found[np.isfinite(found).all(axis=1)]


def rings(curves, matrix, width, height):
    """A ring of pixels around each place in front of the eye.

    :param matrix: (4, 4), from the world to clip coordinates.
    """
    around = _RADIUS * np.stack([np.cos(_TURN), np.sin(_TURN)], -1)
    return [middle + around for curve in curves for middle in
            View(np.array(matrix) @ np.array(curve.matrix_world), width, height).project(places(curve))
            if np.isfinite(middle).all()]


def _draw():
    context = bpy.context
    if not context.space_data.overlay.show_overlays:
        return
    curves = [one for one in context.view_layer.objects
              if one.type == "CURVE" and "talweg_report" in one and one.visible_get()]
    region = context.region
    found = rings(curves, context.region_data.perspective_matrix, region.width, region.height)
    gpu.state.blend_set("ALPHA")
    for width, colour in ((6, _RIM), (3, _RED)):
        for ring in found:
            overlay.polyline(ring, colour, width)
    gpu.state.blend_set("NONE")


class _Handle:
    drawn = None


def register():
    if not bpy.app.background:
        _Handle.drawn = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_PIXEL")


def unregister():
    if _Handle.drawn is not None:
        bpy.types.SpaceView3D.draw_handler_remove(_Handle.drawn, "WINDOW")
        _Handle.drawn = None
