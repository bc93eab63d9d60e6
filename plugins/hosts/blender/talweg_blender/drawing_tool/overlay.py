"""Draws over the view while the tool is active: the drawing, its points, and the point under the mouse."""

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

_LINE = (0.05, 0.05, 0.05, 0.8)
_POINT, _RIM, _UNDER, _END = (1, 1, 1, 1), (0, 0, 0, 1), (1.0, 0.75, 0.1, 1), (0.6, 0.85, 1.0, 1)


class Overlay:
    """The handler that Blender calls after it has drawn the view.

    :param state: a function that returns (Work, View), or None if nothing is to be drawn.
    """

    def __init__(self, state):
        self._state = state
        self._handle = bpy.types.SpaceView3D.draw_handler_add(self._draw, (), "WINDOW", "POST_PIXEL")

    def remove(self):
        if self._handle is not None:
            bpy.types.SpaceView3D.draw_handler_remove(self._handle, "WINDOW")
            self._handle = None

    def _draw(self):
        state = self._state(bpy.context)
        if state is None:
            return
        work, view = state
        gpu.state.blend_set("ALPHA")
        for line in work.editor.lines:
            for run in _strokes(line):
                polyline(view.project(run), _LINE, 1.5)
        handles = [handle for handle in work.handles() if _is_seen(work, view, handle)]
        places = [work.editor.lines[line].points[k] for line, k in handles]
        flat = view.project([place.position for place in places])
        _points(flat, _RIM, 11)
        exact = np.array([place.exact for place in places], bool)
        under = np.array([handle == work.under for handle in handles], bool)
        for colour, wanted in ((_END, ~exact), (_POINT, exact), (_UNDER, under)):
            _points(flat[wanted], colour, 8)
        gpu.state.blend_set("NONE")


def _is_seen(work, view, handle):
    line, k = handle
    return work.ground.sees(view, work.editor.lines[line].points[k].position)


def _strokes(line):
    """The painted parts of a line. Between two exact points nothing was painted."""
    points = line.points + line.points[:1] if line.closed else line.points
    run = []
    for one, other in zip(points, points[1:]):
        if one.exact and other.exact:
            if run:
                yield np.array(run)
            run = []
        else:
            run = [*(run or [one.position]), other.position]
    if run:
        yield np.array(run)


def polyline(flat, colour, width):
    """Draws a polyline through points in pixels; nothing if a point is behind the eye."""
    if not np.isnan(flat).any():
        gpu.state.line_width_set(width)
        _batch("LINE_STRIP", flat, colour)
        gpu.state.line_width_set(1)


def _points(flat, colour, size):
    if len(flat):
        gpu.state.point_size_set(size)
        _batch("POINTS", flat, colour)
        gpu.state.point_size_set(1)


def _batch(kind, flat, colour):
    shader = gpu.shader.from_builtin("2D_UNIFORM_COLOR" if bpy.app.version < (4, 0) else "UNIFORM_COLOR")
    shader.uniform_float("color", colour)
    batch_for_shader(shader, kind, {"pos": flat.astype(np.float32).tolist()}).draw(shader)
