"""Curve files: reads and writes the driver's formats through an extension of the plugin talweg.draw."""

from __future__ import annotations

import ctypes
import logging
import os
from ctypes import byref, sizeof
from typing import TYPE_CHECKING, Any, Callable, List, Optional, Sequence, Union

from . import _arrays, _curves, _plugins
from . import _interface as c
from ._curves import Curve
from ._errors import Unsupported, error_of

if TYPE_CHECKING:
    from ._mesh import Mesh

Path = Union[str, "os.PathLike[str]"]
_MESSAGE_SIZE = 1000
_log = logging.getLogger("talweg")


def _extension() -> Any:
    return extension("talweg.draw", c.CURVE_FILES_3, c.CurveFiles3, "curve files")


def _mesh_view(mesh: Optional[Mesh]) -> Any:
    """A view of the mesh for the extension's functions; the mesh must outlive the view."""
    if mesh is None:
        return None
    return byref(c.Mesh(size=sizeof(c.Mesh), positions=_arrays.view(mesh.vertices),
                        triangles=_arrays.view(mesh.faces)))


def _frame(mesh_unit: Optional[str], mesh: Optional[Mesh]) -> bytes:
    if mesh_unit is None:
        mesh_unit = mesh.frame if mesh is not None else ""
    return (mesh_unit or "mm").encode()


def extension(plugin_id: str, extension_id: bytes, struct: Any, what: str) -> Any:
    """The functions of a plugin's extension that reads and writes files."""
    plugin = _plugins.plugin(plugin_id)
    address = plugin.table.get_extension(extension_id)
    if not address:
        raise Unsupported(f"{plugin.path} is too old to read and write {what}.")
    return struct.from_address(address)


def checked(call: Callable[[Any], Any]) -> str:
    """Runs a call that fills a message buffer; returns the message, which is a note if the call succeeded.

    :raises Error: of the kind of its status.
    """
    message = ctypes.create_string_buffer(_MESSAGE_SIZE)
    status = call(message)
    text = message.value.decode(errors="replace")
    if status != c.OK:
        raise error_of(status, text)
    return text


def read_curves(path: Path, mesh_unit: Optional[str] = None, *,
                mesh: Optional[Mesh] = None) -> List[Curve]:
    """The curves of a file, as input of smooth() and the other functions.

    :param path: .obj, .ply, .vtp, .vtk, .mrk.json and .fcsv (3D Slicer), .border
        (connectome-workbench, with ``mesh``), .json (ours) or .txt (vertices).
    :param mesh_unit: the unit of the mesh ("mm", "cm", "m", "um", ...), or its ``Mesh.frame``, which also has
        its space ("mm RAS"). Curves of 3D Slicer are converted to this unit and space, with a note in the
        logger ``talweg``. None: the frame of ``mesh``; without one, millimetres.
    :param mesh: the mesh of the curves. A .border names the vertices around each point, which become
        points in its faces.
    :raises BadFile: if the file cannot be read; with file, line, and the expected text. Indices are not
        checked against the mesh, except those of a .border.
    :raises BadCurve: if no face of ``mesh`` has the three vertices of a point of a .border.
    """
    curves: List[Curve] = []
    failures: List[BaseException] = []

    def take(_context: Any, curve: Any) -> int:
        try:
            curves.append(_curves.copied_input(curve.contents))
            return c.OK
        except BaseException as error:  # raised again after the call
            failures.append(error)
            return c.HOST_FAILED

    sink = c.Sink(size=sizeof(c.Sink), curve=c.CurveSink(take))
    try:
        notes = checked(lambda message: _extension().read(
            os.fsencode(path), _frame(mesh_unit, mesh), _mesh_view(mesh), byref(sink), message,
            _MESSAGE_SIZE))
    except Exception:
        if failures:
            raise failures[0] from None
        raise
    if notes:
        _log.warning("%s", notes)
    return curves


def write_curves(path: Path, curves: Union[Curve, Sequence[Curve]],
                 mesh_unit: Optional[str] = None, *, mesh: Optional[Mesh] = None) -> None:
    """Writes curves of results, with the same bytes as the driver.

    :param path: its extension names the format, as for read_curves(). .json keeps everything; .txt needs
        curves whose points are all at vertices.
    :param mesh_unit: the unit of the mesh, which .mrk.json files name, or its ``Mesh.frame``: files of 3D
        Slicer are written in LPS. None: the frame of ``mesh``; without one, millimetres.
    :param mesh: the mesh of the curves, which .border files need.
    :raises BadFile: if the file cannot be written; an existing file stays unchanged.
    """
    pointers, kept = _curves.whole_views([curves] if isinstance(curves, Curve) else curves)
    checked(lambda message: _extension().write(os.fsencode(path), _frame(mesh_unit, mesh),
                                               _mesh_view(mesh), pointers, len(pointers), message,
                                               _MESSAGE_SIZE))
    del kept  # the arrays were needed up to this line
