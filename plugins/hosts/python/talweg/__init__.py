"""Smooth curves on triangle meshes and keeps them close to the drawing.

>>> import talweg
>>> mesh = talweg.Mesh(vertices, faces)                # or a file, or a mesh of another package
>>> drawn = talweg.draw(mesh, [12, 845, 9001])         # vertices -> way-points
>>> result = talweg.smooth(mesh, drawn, tau=2)
>>> result.curve.positions, result.report.farthest

Functions take a mesh first: a ``Mesh``, which is opened once for many curves; a file; a pair (vertices,
faces); a mesh of another package. ``Workspace`` keeps a curve while tau moves. ``talweg.help_text()`` lists
all parameters. Lengths are in mesh units, angles in radians.
"""

from ._calls import distance, draw, geodesic, smooth
from ._curves import Curve, CurveLike
from ._errors import (BadCurve, BadFile, BadMesh, BadUsage, Cancelled, Error, Internal, Numerical,
                      OutOfMemory, PluginNotFound, Unsupported)
from ._files import read_curves, write_curves
from ._made import Chain, MadeMesh, Origin
from ._mesh import Mesh, read_mesh, write_mesh
from ._pipeline import Cut, Labels, Measurement, Repair, cut, inspect, labels, measure, offset, repair
from ._plot import plot_curvature
from ._plugins import Parameter, Plugin, folders, help_text, plugin, plugins
from ._results import Distance, Report, Result
from ._show import show
from ._version import __version__
from ._workspace import OneOrEach, Workspace

__all__ = [
    "BadCurve", "BadFile", "BadMesh", "BadUsage", "Cancelled", "Chain", "Curve", "CurveLike",
    "Cut", "Distance", "Error", "Internal", "Labels", "MadeMesh", "Measurement", "Mesh",
    "Numerical", "OneOrEach", "Origin", "OutOfMemory", "Parameter", "Plugin", "PluginNotFound",
    "Repair", "Report", "Result", "Unsupported", "Workspace", "__version__", "cut", "distance",
    "draw", "folders", "geodesic", "help_text", "inspect", "labels", "measure", "offset",
    "plot_curvature", "plugin", "plugins", "read_curves", "read_mesh", "repair", "show",
    "smooth", "write_curves", "write_mesh"
]

for _name in __all__:  # messages name talweg.BadCurve, not the private module that defines it
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
del _name
