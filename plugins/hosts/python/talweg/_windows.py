"""Windows with a scene that the user can turn: PyVista or vedo."""

from __future__ import annotations

import math
import os
import sys
from importlib import import_module
from importlib.util import find_spec
from typing import Any, Dict

import numpy as np

from . import _vtk
from ._attributes import Parts
from ._scene import Scene
from ._shading import BACKGROUND, MATERIAL
from ._types import Array


def there(package: str) -> bool:
    """Whether a package is installed; the package is not loaded."""
    return package in sys.modules or find_spec(package) is not None


def has_display() -> bool:
    """Whether a window can be opened. Without a display VTK would end the program."""
    return sys.platform in ("win32", "darwin") or bool(os.environ.get("DISPLAY"))


def can_render() -> bool:
    """Whether VTK can draw: into a window, or off screen by a library that needs no display."""
    if has_display():
        return True
    import_module("vtkmodules.vtkRenderingOpenGL2")
    window = import_module("vtkmodules.vtkRenderingCore").vtkRenderWindow()
    return window.GetClassName() in ("vtkEGLRenderWindow", "vtkOSOpenGLRenderWindow")


def _surface(scene: Scene) -> Any:
    colors: Dict[str, Array] = {}
    if scene.colors is not None:
        colors["colors"] = np.rint(255 * scene.colors.values).astype(np.uint8)
    at_faces = scene.colors is not None and scene.colors.at_faces
    return _vtk.polydata(Parts(scene.vertices, scene.faces, {} if at_faces else colors,
                               colors if at_faces else {}))


def _position(scene: Scene) -> Array:
    """The viewer's position from which VTK's view angle of 30 degrees shows the same as the scene's
    camera."""
    camera = scene.camera
    away = 0.5 * camera.height / camera.scale / math.tan(math.radians(15))
    return np.asarray(camera.center + away * camera.axes[2])


def pyvista(scene: Scene, off_screen: bool) -> Any:
    """A pyvista.Plotter that is not yet shown."""
    pv = import_module("pyvista")
    camera = scene.camera
    plotter = pv.Plotter(off_screen=off_screen, window_size=[camera.width, camera.height])
    plotter.set_background(tuple(BACKGROUND))
    how = ({"scalars": "colors", "rgb": True} if scene.colors is not None
           else {"color": tuple(MATERIAL)})
    plotter.add_mesh(pv.wrap(_surface(scene)), smooth_shading=True, **how)
    for line in scene.lines:
        plotter.add_mesh(pv.wrap(_vtk.lines(line.polylines)), color=line.color, line_width=2 * line.width,
                         render_lines_as_tubes=True, label=line.name or None)
        if len(line.marks) > 0:
            plotter.add_mesh(pv.PolyData(line.marks), color=line.color, point_size=5 * line.width,
                             render_points_as_spheres=True)
    if any(line.name for line in scene.lines):
        plotter.add_legend(bcolor=tuple(BACKGROUND))
    plotter.camera_position = [tuple(_position(scene)), tuple(camera.center), tuple(camera.axes[1])]
    plotter.reset_camera_clipping_range()
    return plotter


def vedo(scene: Scene, off_screen: bool) -> Any:
    """A vedo.Plotter that is drawn and does not wait for the user."""
    vd = import_module("vedo")
    camera = scene.camera
    surface = vd.Mesh(_surface(scene)).phong()
    if scene.colors is None:
        surface.c(tuple(MATERIAL))
    else:
        surface.pointdata.select("colors") if not scene.colors.at_faces else (
            surface.celldata.select("colors"))
    actors = [surface]
    for line in scene.lines:
        actor = vd.Mesh(_vtk.lines(line.polylines)).c(line.color).lw(2 * line.width)
        actor.render_lines_as_tubes(True)
        actor.name = line.name
        actors.append(actor)
        if len(line.marks) > 0:
            actors.append(vd.Points(line.marks, r=5 * line.width).c(line.color))
    plotter = vd.Plotter(offscreen=off_screen, size=(camera.width, camera.height),
                         bg=tuple(BACKGROUND))
    plotter.show(actors, interactive=False, camera={
        "pos": tuple(_position(scene)), "focal_point": tuple(camera.center),
        "viewup": tuple(camera.axes[1])})
    return plotter
