"""Meshes of other packages, in and out: trimesh, meshio, VTK, PyVista and vedo."""

from __future__ import annotations

import logging
from importlib import import_module
from typing import Any, Dict, List, Tuple

import numpy as np

from . import _vtk
from ._attributes import Attributes, Parts, of_numbers
from ._errors import BadMesh
from ._polygons import triangulated
from ._types import Array

_log = logging.getLogger("talweg")
_COLORS, _UV = "colors", "uv"


def parts_of(mesh: Any) -> Parts:
    """The lists of another package's mesh.

    :raises BadMesh: if the object is not a mesh, or has neither triangles nor polygons.
    """
    polydata = _vtk.polydata_of(mesh)
    if polydata is not None:
        return _vtk.parts_of(polydata)
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return _of_trimesh(mesh)
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):
        return _of_meshio(mesh)
    raise BadMesh("A mesh is given as a pair of vertices (n, 3) and faces (m, 3), or as an object "
                  "with vertices and faces, or points and cells, or as vtkPolyData, or as a file, "
                  f"not as {type(mesh).__name__}.")


def _of_trimesh(mesh: Any) -> Parts:
    at_vertices = of_numbers(getattr(mesh, "vertex_attributes", {}))
    at_faces = of_numbers(getattr(mesh, "face_attributes", {}))
    at_corners: Any = getattr(mesh, "corner_attributes", None)  # a talweg.Mesh
    if at_corners is None:
        at_corners = getattr(mesh, "metadata", {}).get("corner_attributes", {})
    visual: Any = getattr(mesh, "visual", None)
    kind = getattr(visual, "kind", None)  # trimesh would invent colours of another kind
    if kind == "vertex":
        at_vertices.setdefault(_COLORS, np.asarray(visual.vertex_colors))
    elif kind == "face":
        at_faces.setdefault(_COLORS, np.asarray(visual.face_colors))
    elif kind == "texture" and getattr(visual, "uv", None) is not None:
        at_vertices.setdefault(_UV, np.asarray(visual.uv))
    return Parts(mesh.vertices, mesh.faces, at_vertices, at_faces, of_numbers(at_corners))


def _of_meshio(mesh: Any) -> Parts:
    blocks = [k for k, block in enumerate(mesh.cells)
              if block.type in ("triangle", "quad", "polygon") and len(block.data) > 0]
    if not blocks:
        raise BadMesh("The mesh has no triangles, quads or polygons.")
    at_vertices = of_numbers(getattr(mesh, "point_data", {}))
    data: Dict[str, List[Any]] = getattr(mesh, "cell_data", {})
    if len(blocks) == 1 and mesh.cells[blocks[0]].type == "triangle":  # without a copy
        at_faces = of_numbers({name: values[blocks[0]] for name, values in data.items()})
        return Parts(mesh.points, mesh.cells[blocks[0]].data, at_vertices, at_faces)
    parts = [_triangles_of(mesh.points, np.asarray(mesh.cells[k].data)) for k in blocks]
    at_faces = of_numbers({
        name: np.concatenate([np.asarray(values[k])[polygons] for k, (_, polygons) in
                              zip(blocks, parts)]) for name, values in data.items()})
    return Parts(mesh.points, np.concatenate([triangles for triangles, _ in parts]), at_vertices,
                 at_faces)


def _triangles_of(points: Array, block: Array) -> Tuple[Array, Array]:
    return triangulated(points, block.reshape(-1), np.full(len(block), block.shape[1]))


def to_trimesh(parts: Parts) -> Any:
    """A trimesh.Trimesh, with attributes of corners in its metadata."""
    trimesh = import_module("trimesh")
    at_vertices, at_faces = dict(parts.vertex_attributes), dict(parts.face_attributes)
    colours = {where: values.pop(_COLORS) for where, values in
               (("vertex_colors", at_vertices), ("face_colors", at_faces))
               if _are_colours(values.get(_COLORS))}
    visual = None
    uv = at_vertices.get(_UV)
    if not colours and uv is not None and np.shape(uv)[1:] == (2,):
        visual = trimesh.visual.TextureVisuals(uv=at_vertices.pop(_UV))
    return trimesh.Trimesh(parts.vertices, parts.faces, process=False, visual=visual,
                           vertex_attributes=at_vertices, face_attributes=at_faces,
                           metadata={"corner_attributes": dict(parts.corner_attributes)}
                           if parts.corner_attributes else None, **colours)


def _are_colours(values: Any) -> bool:
    return values is not None and values.dtype == np.uint8 and values.shape[1:] in ((3,), (4,))


def to_meshio(parts: Parts) -> Any:
    """A meshio.Mesh of triangles. Attributes of corners, which meshio does not have, are left out with a
    warning."""
    meshio = import_module("meshio")
    if parts.corner_attributes:
        _log.warning("meshio has no attributes of corners: %s left out.",
                     ", ".join(parts.corner_attributes))
    at_faces: Attributes = dict(parts.face_attributes)
    return meshio.Mesh(parts.vertices, [("triangle", parts.faces)],
                       point_data=dict(parts.vertex_attributes),
                       cell_data={name: [values] for name, values in at_faces.items()})


def to_pyvista(parts: Parts) -> Any:
    """A pyvista.PolyData."""
    return import_module("pyvista").wrap(_vtk.polydata(parts))
