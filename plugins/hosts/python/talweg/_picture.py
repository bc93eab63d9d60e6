"""Pictures by matplotlib, without a window: the surface as an image, with curves as lines over it."""

from __future__ import annotations

import io
import os
from importlib import import_module
from typing import Any, List, Tuple, Union

import numpy as np

from . import _colors
from ._errors import BadFile, BadUsage
from ._scene import Line, Scene
from ._shading import BACKGROUND, Surface
from ._types import Array, Floats

DPI = 100
_STEP = 1.5  # pixels between two samples of a curve's visibility
_SHORT = 4  # samples; a shorter hidden or visible part joins its neighbours


def figure(scene: Scene, unit: str) -> Any:
    """A matplotlib figure that needs no window."""
    canvas = import_module("matplotlib.backends.backend_agg").FigureCanvasAgg
    camera = scene.camera
    made = import_module("matplotlib.figure").Figure(
        figsize=(camera.width / DPI, camera.height / DPI), dpi=DPI)
    canvas(made)
    draw(made.add_axes([0, 0, 1, 1]), scene, unit)
    return made


def draw(axes: Any, scene: Scene, unit: str) -> None:
    """Draws the scene into axes of matplotlib, whose units become pixels."""
    camera = scene.camera
    colors = scene.colors
    surface = Surface(scene.vertices, scene.faces, camera, colors.values if colors else None,
                      colors.at_faces if colors else False)
    axes.imshow(surface.image(), extent=(-0.5, camera.width - 0.5, camera.height - 0.5, -0.5),
                interpolation="antialiased", zorder=0)
    for order, line in enumerate(scene.lines):
        _draw_line(axes, surface, line, 2 + order)
    axes.set_axis_off()
    axes.set(xlim=(-0.5, camera.width - 0.5), ylim=(camera.height - 0.5, -0.5))
    _draw_scale(axes, scene, unit)
    if colors is not None and colors.extent is not None:
        _draw_ramp(axes, colors)
    _draw_legend(axes, scene)


def _draw_line(axes: Any, surface: Surface, line: Line, order: int) -> None:
    collections = import_module("matplotlib.collections")
    effects = import_module("matplotlib.patheffects")
    clear: List[Floats] = []
    hidden: List[Floats] = []
    for points in line.polylines:
        seen = surface.camera.project(points)
        for run in _sampled(seen, surface.camera.width, surface.camera.height):
            for piece, behind in _pieces(surface, run):
                (hidden if behind else clear).append(piece)
    axes.add_collection(collections.LineCollection(
        hidden, colors=line.color, linewidths=0.7 * line.width, linestyles=":", alpha=0.6,
        zorder=order))
    axes.add_collection(collections.LineCollection(
        clear, colors=line.color, linewidths=line.width, capstyle="round", joinstyle="round",
        zorder=order, path_effects=[
            effects.Stroke(linewidth=line.width + 1.2, foreground="white", alpha=0.55),
            effects.Normal()]))
    if len(line.marks) > 0:
        seen = surface.camera.project(line.marks)
        seen = seen[~surface.hides(seen)]
        axes.scatter(seen[:, 0], seen[:, 1], s=(3.2 * line.width) ** 2, facecolors="white",
                     edgecolors=line.color, linewidths=1.0, zorder=60)


def _sampled(points: Floats, width: int, height: int) -> List[Floats]:
    """Samples in short steps along a polyline in pixels, as one list for each stretch in or near the
    frame."""
    size = np.array([width, height])
    if len(points) == 1:
        return []
    a, b = points[:-1], points[1:]
    near = np.all((np.maximum(a, b)[:, :2] > -20) & (np.minimum(a, b)[:, :2] < size + 20), axis=1)
    counts = np.clip(np.ceil(np.linalg.norm((b - a)[:, :2], axis=1) / _STEP), 1, 4 * max(size))
    counts = np.where(near, counts, 0).astype(np.int64)
    segment = np.repeat(np.arange(len(a)), counts)
    ends = np.cumsum(counts)
    part = (np.arange(len(segment)) - (ends - counts)[segment]) / counts[segment]
    samples = a[segment] + part[:, None] * (b - a)[segment]
    runs = []
    for first, last in _runs(near):
        if near[first]:
            inside = samples[ends[first] - counts[first]:ends[last - 1]]
            runs.append(np.vstack([inside, points[last]]))
    return runs


def _runs(flags: Array) -> List[Tuple[int, int]]:
    """The ranges of equal flags."""
    changes = np.flatnonzero(np.diff(flags.astype(np.int8))) + 1
    bounds = [0, *changes.tolist(), len(flags)]
    return list(zip(bounds[:-1], bounds[1:]))


def _pieces(surface: Surface, samples: Floats) -> List[Tuple[Floats, bool]]:
    """Parts of a line in pixels, each with whether the surface hides it."""
    hidden = surface.hides(samples)
    for first, last in _runs(hidden):
        if last - first < _SHORT and 0 < first and last < len(hidden):
            hidden[first:last] = hidden[first - 1]
    return [(samples[first:last + 1, :2], bool(hidden[first])) for first, last in _runs(hidden)]


def _draw_scale(axes: Any, scene: Scene, unit: str) -> None:
    """Draws a scale bar of a round length."""
    camera = scene.camera
    most = 0.22 * camera.width / camera.scale
    power = 10.0 ** np.floor(np.log10(most))
    length = max(k * power for k in (1, 2, 5) if k * power <= most * (1 + 1e-9))
    right, low = camera.width - 24, camera.height - 18
    axes.plot([right - length * camera.scale, right], [low, low], color="#33333a", linewidth=2.5,
              solid_capstyle="butt", zorder=90)
    axes.text(right, low - 7, f"{length:g} {unit}".rstrip(), ha="right", va="bottom", fontsize=9,
              color="#33333a", zorder=90)


def _draw_ramp(axes: Any, colors: _colors.Colors) -> None:
    bar = axes.inset_axes([0.03, 0.3, 0.02, 0.4])
    low, high = colors.extent or (0.0, 0.0)
    bar.imshow(_colors.ramp(np.linspace(1, 0, 128))[:, None], aspect="auto", extent=(0, 1, low, high)
               if high > low else (0, 1, low - 0.5, low + 0.5))
    bar.set_xticks([])
    bar.yaxis.tick_right()
    bar.tick_params(labelsize=8)
    bar.set_title(colors.name, fontsize=9, loc="left")


def _draw_legend(axes: Any, scene: Scene) -> None:
    line = import_module("matplotlib.lines").Line2D
    named = [line([], [], color=one.color, linewidth=one.width, label=one.name)
             for one in scene.lines if one.name]
    if named:
        axes.legend(handles=named, loc="lower left", fontsize=9, framealpha=0.8,
                    facecolor=tuple(BACKGROUND), edgecolor="none").set_zorder(91)


def png(made: Any) -> bytes:
    """The figure as the bytes of a PNG file."""
    out = io.BytesIO()
    made.savefig(out, format="png", dpi=DPI, metadata={"Software": None})
    return out.getvalue()


def write(made: Any, path: Union[str, "os.PathLike[str]"]) -> None:
    """Writes a figure in the format that the file's extension names.

    :raises BadUsage: for an extension that matplotlib does not know. :raises BadFile: if the file
        cannot be written.
    """
    kinds = made.canvas.get_supported_filetypes()
    kind = os.path.splitext(os.fspath(path))[1][1:].lower()
    if kind not in kinds:
        raise BadUsage(f"{os.fspath(path)}: pictures end in {', '.join('.' + k for k in kinds)}.")
    try:
        made.savefig(path, format=kind, dpi=DPI)
    except OSError as error:
        raise BadFile(f"{os.fspath(path)} cannot be written: {error.strerror or error}.") from None
