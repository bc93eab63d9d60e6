"""talweg.show(): pictures and windows by the installed packages."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from typing import Any, Optional, Tuple, Union

from . import _picture, _windows
from ._errors import BadFile, BadUsage, Unsupported
from ._results import Result
from ._scene import DRAWN, MESH_UNITS, Scene, scene

_ENGINES = ("pyvista", "vedo", "matplotlib")


def show(mesh: Any, curves: Any = None, *, file: Union[None, str, "os.PathLike[str]"] = None,
         engine: Optional[str] = None, view: Any = None, up: Any = None, zoom: float = 1.0,
         colors: Any = None, unit: str = MESH_UNITS, size: Tuple[int, int] = (800, 600),
         axes: Any = None) -> Any:
    """Shows curves on their mesh: a window, a picture in a notebook, or a picture in a file.

    :param mesh: a ``Mesh``, a mesh of another package, or a pair of arrays (vertices, faces). It need not be
        a surface.
    :param curves: a curve as for smooth(); a list of ``Curve``; a ``Result``, with its drawing; or a
        dictionary of these by name, for a legend. Curves with the name "drawn" are thin and red.
    :param file: a picture to write: .png, .pdf, .svg, ... Needs no window.
    :param engine: "pyvista", "vedo" or "matplotlib". None: for a window the first installed one; for files
        and notebooks matplotlib.
    :param view: a direction (3,) from the mesh towards the viewer. None: the direction that shows most of the
        curves; equal input has equal views.
    :param up: a direction (3,) that is upright in the picture. None: y; for open sheets such as terrains, the
        side that the sheet faces.
    :param zoom: > 0; a factor for the size of the curves in the picture; 1 shows them with their
        surroundings.
    :param colors: of the surface: the name of an attribute of vertices or faces; (n,) or (m,) real numbers,
        shown by a ramp, or whole numbers, shown as labels; or (n, 3) or (m, 3) colours, bytes or real numbers
        in [0, 1].
    :param unit: unit of the mesh, for the scale bar.
    :param size: of the picture or window, pixels, in [16, 8192].
    :param axes: axes of matplotlib, to draw into; nothing is shown then.
    :returns: None; with ``axes`` the axes; with an engine for windows its plotter.
    :raises BadMesh, BadCurve, BadUsage: if an argument is wrong; the sentence names it.
    :raises BadFile: if the file cannot be written.
    :raises Unsupported: if the needed package is not installed, or no window can be opened.

    matplotlib draws the surface as an image; hidden parts of curves are dotted.
    """
    if engine is not None and engine not in _ENGINES:
        raise BadUsage(f"engine must be one of {', '.join(_ENGINES)}, not {engine!r}.")
    chosen = engine or _engine(file is not None or axes is not None)
    if not _windows.there(chosen):
        raise Unsupported(f"There is no {chosen}" + (
            "." if engine else " (Debian: python3-matplotlib), PyVista or vedo to show it with."))
    if isinstance(curves, Result):
        curves = curves_of(curves)
    seen = scene(mesh, curves, view, up, zoom, colors, size)
    if chosen == "matplotlib":
        return _by_matplotlib(seen, file, unit, axes)
    if axes is not None:
        raise BadUsage(f"axes are matplotlib's, so the engine cannot be {chosen}.")
    return _by_vtk(chosen, seen, file)


def curves_of(result: Result) -> Any:
    """The curves of a result and its drawing, by name."""
    return {DRAWN: result.drawn or None, "result": result.curves or None}


def png(result: Result) -> Optional[bytes]:
    """A picture of a result for a notebook; None without matplotlib, curves or mesh."""
    if result.mesh is None or not result.curves or not _windows.there("matplotlib"):
        return None
    seen = scene(result.mesh, curves_of(result), None, None, 1.0, None, (800, 600))
    return _picture.png(_picture.figure(seen, MESH_UNITS))


def _in_notebook() -> bool:
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return hasattr(shell, "kernel")


def _engine(picture: bool) -> str:
    if not picture and not _in_notebook() and _windows.has_display():
        for engine in _ENGINES[:2]:
            if _windows.there(engine):
                return engine
    return "matplotlib"


def _by_matplotlib(seen: Scene, file: Any, unit: str, axes: Any) -> Any:
    if axes is not None:
        _picture.draw(axes, seen, unit)
        return axes
    if file is not None:
        _picture.write(_picture.figure(seen, unit), file)
    elif _in_notebook():
        picture = import_module("IPython.display").Image(
            _picture.png(_picture.figure(seen, unit)), format="png")
        import_module("IPython.display").display(picture)
    else:
        _open_window(seen, unit)
    return None


def _open_window(seen: Scene, unit: str) -> None:
    pyplot = import_module("matplotlib.pyplot")
    backends = import_module("matplotlib").rcsetup.interactive_bk
    if pyplot.get_backend().lower() not in [name.lower() for name in backends]:
        raise Unsupported("There is no window to show it in; give a picture's name: "
                          'file="picture.png".')
    width, height = seen.camera.width / _picture.DPI, seen.camera.height / _picture.DPI
    _picture.draw(pyplot.figure(figsize=(width, height), dpi=_picture.DPI).add_axes([0, 0, 1, 1]),
                  seen, unit)
    pyplot.show()


def _by_vtk(engine: str, seen: Scene, file: Any) -> Any:
    if not _windows.can_render():
        raise Unsupported(f"{engine} needs a display, and there is none; pictures of matplotlib "
                          'do not: engine="matplotlib", file="picture.png".')
    plotter = getattr(_windows, engine)(seen, file is not None)
    if file is None:
        getattr(plotter, "interactive" if engine == "vedo" else "show")()
    else:
        plotter.screenshot(os.fspath(file))
        plotter.close()
        if not os.path.isfile(file):
            raise BadFile(f"{os.fspath(file)} was not written.")
    return plotter
