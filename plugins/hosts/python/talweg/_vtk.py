"""vtkPolyData as input and output. Meshes of PyVista and vedo are, or hold, a vtkPolyData. Needs VTK 9."""

from __future__ import annotations

from importlib import import_module
from typing import Any, Optional, Sequence

import numpy as np

from ._attributes import Attributes, Parts
from ._errors import BadMesh
from ._polygons import triangulated
from ._types import Array, ArrayLike

_CORNER = "corner:"  # the prefix of attributes of corners, which become field data, since VTK has none


def _numpy() -> Any:
    return import_module("vtkmodules.util.numpy_support")


def _data_model() -> Any:
    return import_module("vtkmodules.vtkCommonDataModel")


def polydata_of(mesh: Any) -> Optional[Any]:
    """The vtkPolyData that a mesh of VTK, PyVista or vedo is or holds; None for any other object.

    :raises BadMesh: for another data set of VTK.
    """
    if hasattr(mesh, "dataset") and hasattr(mesh.dataset, "IsA"):  # vedo 2023.5 and later
        mesh = mesh.dataset
    elif callable(getattr(mesh, "polydata", None)):  # vedo before
        mesh = mesh.polydata()
    if not hasattr(mesh, "IsA"):
        return None
    if mesh.IsA("vtkPolyData"):
        return mesh
    raise BadMesh(f"A mesh of VTK must be vtkPolyData, not {mesh.GetClassName()} "
                  "(vtkGeometryFilter, or PyVista's extract_surface(), makes one).")


def parts_of(polydata: Any) -> Parts:
    """The polygons of a vtkPolyData, triangulated, with point and cell data."""
    if polydata.GetNumberOfStrips() > 0:
        raise BadMesh("The mesh has triangle strips; vtkTriangleFilter makes triangles of them.")
    if polydata.GetNumberOfPolys() == 0:
        raise BadMesh("The mesh has no triangles, quads or polygons.")
    polygons = polydata.GetPolys()
    corners = _numpy().vtk_to_numpy(polygons.GetConnectivityArray())
    sizes = np.diff(_numpy().vtk_to_numpy(polygons.GetOffsetsArray()))
    at_polygons = slice(polydata.GetNumberOfVerts() + polydata.GetNumberOfLines(), None)
    at_faces = {name: values[at_polygons] for name, values in _read(polydata.GetCellData()).items()}
    at_corners: Attributes = {}
    points = _numpy().vtk_to_numpy(polydata.GetPoints().GetData())
    if np.all(sizes == 3):
        faces = corners.reshape(-1, 3)
        at_corners = _corners(_read(polydata.GetFieldData()), len(faces))
    else:
        faces, polygon = triangulated(points, corners, sizes)
        at_faces = {name: values[polygon] for name, values in at_faces.items()}
    return Parts(points, faces, _read(polydata.GetPointData()), at_faces, at_corners)


def _read(data: Any) -> Attributes:
    arrays = [data.GetArray(k) for k in range(data.GetNumberOfArrays())]  # None for arrays of texts
    return {array.GetName(): _numpy().vtk_to_numpy(array) for array in arrays
            if array is not None and array.GetName() and not array.IsA("vtkBitArray")}


def _corners(fields: Attributes, faces: int) -> Attributes:
    return {name[len(_CORNER):]: values.reshape(faces, 3, *values.shape[1:])
            for name, values in fields.items()
            if name.startswith(_CORNER) and len(values) == 3 * faces}


def _add(data: Any, name: str, values: ArrayLike) -> None:
    array: Array = np.asarray(values)
    array = array.reshape(len(array), -1) if array.ndim > 2 else array
    if array.dtype.kind == "b":
        array = array.astype(np.uint8)
    elif array.dtype == np.float16 or array.dtype.kind == "f" and array.itemsize > 8:
        array = array.astype(np.float64)
    made = _numpy().numpy_to_vtk(np.ascontiguousarray(array, array.dtype.newbyteorder("=")), deep=True)
    made.SetName(name)
    data.AddArray(made)


def _cells(corners: Array, offsets: Array) -> Any:
    """A vtkCellArray from the corners of all cells in order, and the offset at which each cell begins."""
    cells = _data_model().vtkCellArray()
    as_ids = _numpy().numpy_to_vtkIdTypeArray
    cells.SetData(as_ids(offsets.astype(np.int64), deep=True),
                  as_ids(np.ascontiguousarray(corners, np.int64), deep=True))
    return cells


def _with_points(points: ArrayLike) -> Any:
    array = np.asarray(points)
    kind = np.float32 if array.dtype == np.float32 else np.float64
    coordinates = import_module("vtkmodules.vtkCommonCore").vtkPoints()
    coordinates.SetData(_numpy().numpy_to_vtk(np.ascontiguousarray(array, kind), deep=True))
    result = _data_model().vtkPolyData()
    result.SetPoints(coordinates)
    return result


def polydata(parts: Parts) -> Any:
    """A vtkPolyData of triangles with all attributes."""
    result = _with_points(parts.vertices)
    faces = np.asarray(parts.faces)
    result.SetPolys(_cells(faces.reshape(-1), np.arange(0, faces.size + 1, 3)))
    for data, attributes in ((result.GetPointData(), parts.vertex_attributes),
                             (result.GetCellData(), parts.face_attributes)):
        for name, values in attributes.items():
            _add(data, name, values)
    for name, values in parts.corner_attributes.items():
        array = np.asarray(values)
        _add(result.GetFieldData(), _CORNER + name, array.reshape(-1, *array.shape[2:]))
    return result


def lines(polylines: Sequence[Array]) -> Any:
    """A vtkPolyData with a line for each polyline, (n, 3) each."""
    ends = np.cumsum([len(points) for points in polylines])
    result = _with_points(np.concatenate(polylines))
    result.SetLines(_cells(np.arange(ends[-1]), np.r_[0, ends]))
    return result
