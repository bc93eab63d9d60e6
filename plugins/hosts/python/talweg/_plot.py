"""talweg.plot_curvature(): curvature along a result, and along its drawing."""

from __future__ import annotations

import os
from importlib import import_module
from typing import Any, Optional, Union

import numpy as np

from . import _picture, _windows
from ._curves import Curve
from ._errors import BadUsage, Error, Unsupported
from ._mesh import Mesh
from ._results import Result
from ._scene import BLUE, MESH_UNITS, OTHERS, RED
from ._turning import Turns, turns_of

_AIR = 1.08  # the plotted range as a multiple of the result's largest curvature


def plot_curvature(result: Result, axes: Any = None, *, window: Optional[float] = None,
                   unit: str = MESH_UNITS,
                   file: Union[None, str, "os.PathLike[str]"] = None) -> Any:
    """Plots the signed geodesic curvature along a result, over that of its drawing.

    The curvature at a place is the sum of the turns in a window around the place over the window's length;
    positive for turns to the left, seen from outside. The range of the plot fits the result; larger curvature
    of the drawing is cut off. Drawings are stretched to the length of their results.

    :param axes: of matplotlib, to draw into. None: new ones of ``matplotlib.pyplot``.
    :param window: mesh units, > 0. None: twice the edge length near the drawing; smaller windows show single
        turns.
    :param unit: unit of the mesh, for the labels of the axes.
    :param file: a picture to write: .png, .pdf, .svg, ... Needs no window; with ``axes`` the picture has
        their whole figure.
    :returns: the axes.
    :raises BadUsage: for a result without curves or mesh, or a window that is not > 0.
    :raises BadFile: if the file cannot be written. :raises Unsupported: without matplotlib.
    """
    if not _windows.there("matplotlib"):
        raise Unsupported("There is no matplotlib (Debian: python3-matplotlib).")
    if result.mesh is None or not result.curves:
        raise BadUsage("The result has no curves, or does not know its mesh.")
    if axes is None:
        axes = _new_axes(file is not None)
    most = most_before = 0.0
    for k, curve in enumerate(result.curves):
        turns = _turns(curve, result.mesh)
        width = _window(window, result, k, turns)
        steps, values = turns.curvature_along(width)
        name = "result" if len(result.curves) == 1 else f"result {k + 1}"
        axes.stairs(values, steps, baseline=None, linewidth=1.6, label=name,
                    color=(BLUE, *OTHERS)[k % (1 + len(OTHERS))], zorder=3)
        most = max(most, float(np.abs(values).max(initial=0)))
        before = _of_drawing(result, k)
        if before is not None and before.length > 0:
            steps, values = before.curvature_along(width)
            axes.stairs(values, steps * (turns.length / before.length), baseline=None,
                        linewidth=0.9, color=RED, alpha=0.4, zorder=2,
                        label="drawn" if k == 0 else None)
            most_before = max(most_before, float(np.abs(values).max(initial=0)))
    extent = _AIR * (most or most_before or 1.0)
    axes.set(ylim=(-extent, extent), xlabel=f"along the curve ({unit})",
             ylabel=f"curvature (rad / {'mesh unit' if unit == MESH_UNITS else unit})")
    axes.axhline(0, color="#9e9e9e", linewidth=0.8, zorder=1)
    axes.legend(loc="upper right")
    if file is not None:
        _picture.write(axes.figure, file)
    return axes


def _new_axes(for_file: bool) -> Any:
    size = {"figsize": (8, 3), "layout": "constrained"}
    if not for_file:
        return import_module("matplotlib.pyplot").subplots(**size)[1]
    figure = import_module("matplotlib.figure").Figure(**size)
    import_module("matplotlib.backends.backend_agg").FigureCanvasAgg(figure)
    return figure.add_subplot()


def _turns(curve: Curve, mesh: Mesh) -> Turns:
    turns = turns_of(curve, np.asarray(mesh.vertices, dtype=np.float64),
                     np.asarray(mesh.faces, dtype=np.int64))
    if not turns.length > 0:
        raise BadUsage("A curve without length has no curvature.")
    return turns


def _window(given: Optional[float], result: Result, k: int, turns: Turns) -> float:
    if given is not None:
        if not (isinstance(given, (int, float)) and 0 < given < np.inf):
            raise BadUsage(f"window must be a length greater than 0, not {given!r}.")
        return float(given)
    edge = result.reports[k].edge_length_near if k < len(result.reports) else None
    return 2 * edge if edge else turns.length / 50


def _of_drawing(result: Result, k: int) -> Optional[Turns]:
    """The turns of the k-th drawing; None if there is none, or if it cannot be laid on the mesh."""
    if k >= len(result.drawn) or result.mesh is None:
        return None
    drawn = result.drawn[k]
    try:
        if drawn.vertices is None or np.any(np.asarray(drawn.vertices) == -1):
            drawn = result.mesh.draw(drawn, straight=True, exact=False)
        return _turns(drawn, result.mesh)
    except Error:
        return None
