"""Meshes, opened once."""

from __future__ import annotations

import threading
from typing import Any, Dict, Mapping, Optional, Sequence, Union

from . import _arrays, _attributes, _convert, _plugins, _vtk
from ._attributes import Parts
from ._curves import Curve, CurveLike, as_curve
from ._errors import BadMesh
from ._instance import Instance
from ._interruptible import as_progress
from ._results import Distance, Result
from ._types import ArrayLike
from ._version import __version__
from ._workspace import OneOrEach, Workspace


class Mesh:
    """A triangle mesh, opened: checked and copied once, then shared by all that works on it.

    :param vertices: (n, 3) real numbers, float64 or float32, mesh units. Or, without ``faces``, a
        mesh of trimesh, meshio, VTK (``vtkPolyData``), PyVista or vedo, with its attributes;
        polygons become fans.
    :param faces: (m, 3) whole numbers, counterclockwise from outside.
    :param vertex_attributes: arrays of numbers by name, of shape (n, ...).
    :param face_attributes: (m, ...) each.
    :param corner_attributes: (m, 3, ...) each: the corners of the faces, in their order.
    :raises BadMesh: if it is no oriented manifold; the sentence says where.
    :raises BadUsage: for an attribute of another shape, or one that holds no numbers.

    The arrays are not copied on our side where the interface can read them as they are (any
    strides of rows; float32, float64; 32- and 64-bit integers). They are looked at again when
    another plugin is first used, so leave them unchanged. Any thread may use the mesh; a
    workspace belongs to one at a time. A pickled mesh is opened again when it is first used.
    """

    def __init__(self, vertices: Any, faces: Optional[ArrayLike] = None, *,
                 vertex_attributes: Optional[Mapping[str, ArrayLike]] = None,
                 face_attributes: Optional[Mapping[str, ArrayLike]] = None,
                 corner_attributes: Optional[Mapping[str, ArrayLike]] = None,
                 progress: Any = None, plugin: str = "talweg.smooth") -> None:
        parts = _convert.parts_of(vertices) if faces is None else Parts(vertices, faces)
        self.vertices = _arrays.readable(parts.vertices, 3, "The mesh's vertices", BadMesh)
        self.faces = _arrays.readable(parts.faces, 3, "The mesh's faces", BadMesh)
        self._keep_attributes({**parts.vertex_attributes, **(vertex_attributes or {})},
                              {**parts.face_attributes, **(face_attributes or {})},
                              {**parts.corner_attributes, **(corner_attributes or {})})
        self._begin()
        self._instance(plugin, progress)

    def _keep_attributes(self, at_vertices: Mapping[str, ArrayLike],
                         at_faces: Mapping[str, ArrayLike],
                         at_corners: Mapping[str, ArrayLike]) -> None:
        n, m = len(self.vertices), len(self.faces)
        #: Arrays by name, with a row for each vertex, face, or (m, 3, ...) corner; may be changed.
        self.vertex_attributes = _attributes.checked(at_vertices, (n,), "vertex")
        self.face_attributes = _attributes.checked(at_faces, (m,), "face")
        self.corner_attributes = _attributes.checked(at_corners, (m, 3), "corner")

    def _begin(self) -> None:
        self._owners: Dict[str, Instance] = {}
        self._opening = threading.Lock()
        self._closed: Optional[Mesh] = None

    def _as_closed(self) -> Mesh:
        """The same mesh, to be opened when it is used: results keep it, and not all that is open."""
        with self._opening:
            if self._closed is None:
                self._closed = Mesh.__new__(Mesh)
                self._closed.__setstate__(self.__getstate__())
            return self._closed

    def __getstate__(self) -> Dict[str, Any]:
        return {name: value for name, value in vars(self).items() if not name.startswith("_")}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        vars(self).update(state)
        self._begin()

    def __repr__(self) -> str:
        return f"<talweg.Mesh: {len(self.vertices)} vertices, {len(self.faces)} faces>"

    def _parts(self) -> Parts:
        self._keep_attributes(self.vertex_attributes, self.face_attributes, self.corner_attributes)
        return Parts(self.vertices, self.faces, self.vertex_attributes, self.face_attributes,
                     self.corner_attributes)

    def to_trimesh(self) -> Any:
        """A ``trimesh.Trimesh`` with the same numbering. The vertex or face attribute ``colors``
        ((n, 3) or (n, 4) bytes) becomes its colours, the vertex attribute ``uv`` (n, 2) its texture
        coordinates; attributes of corners are in ``metadata["corner_attributes"]``.

        :raises ImportError: without trimesh. :raises BadUsage: for wrong attributes.
        """
        return _convert.to_trimesh(self._parts())

    def to_meshio(self) -> Any:
        """A ``meshio.Mesh`` with point and cell data; attributes of corners have no place there.

        :raises ImportError: without meshio. :raises BadUsage: for wrong attributes.
        """
        return _convert.to_meshio(self._parts())

    def to_vtk(self) -> Any:
        """A ``vtkPolyData`` with point and cell data; attributes of corners are field data
        ``corner:NAME``, three rows for each face. Attributes with more than one column more are
        flattened.

        :raises ImportError: without VTK 9. :raises BadUsage: for wrong attributes.
        """
        return _vtk.polydata(self._parts())

    def to_pyvista(self) -> Any:
        """The same as a ``pyvista.PolyData``. :raises ImportError: without PyVista."""
        return _convert.to_pyvista(self._parts())

    def _instance(self, plugin: str, progress: Any = None) -> Instance:
        """A new instance of the plugin, with the mesh."""
        found = _plugins.plugin(plugin)
        with self._opening:
            if plugin not in self._owners:
                owner = Instance(found, __version__)
                owner.set_mesh(self.vertices, self.faces, as_progress(progress))
                self._owners[plugin] = owner
            instance = Instance(found, __version__)
            instance.share_mesh(self._owners[plugin])
        return instance

    def workspace(self, curves: Union[CurveLike, Sequence[Curve], None] = None, *,
                  closed: bool = False, plugin: str = "talweg.smooth",
                  **parameters: Any) -> "Workspace":
        """A workspace on this mesh; see Workspace."""
        return Workspace(self, curves, closed=closed, plugin=plugin, **parameters)

    def smooth(self, curve: Union[CurveLike, Sequence[Curve]], tau: OneOrEach = 1.0, *,
               closed: bool = False, point_fields: bool = False, vertex_fields: bool = False,
               progress: Any = None, **parameters: Any) -> Result:
        """talweg.smooth() on this mesh."""
        work = Workspace(self, curve, closed=closed, progress=progress)
        return work.smooth(tau, point_fields=point_fields, vertex_fields=vertex_fields,
                           progress=progress, **parameters)

    def draw(self, points: CurveLike, *, closed: bool = False, straight: bool = False,
             exact: bool = True) -> Curve:
        """talweg.draw() on this mesh."""
        work = Workspace(self, as_curve(points, closed), plugin="talweg.draw", straight=straight,
                         points="exact" if exact else "rough")
        return work.run().curve

    def geodesic(self, curve: Union[CurveLike, Sequence[Curve]], *, closed: bool = False,
                 point_fields: bool = False, progress: Any = None, **parameters: Any) -> Result:
        """talweg.geodesic() on this mesh."""
        work = Workspace(self, curve, closed=closed, plugin="talweg.geodesic", **parameters)
        return work.run(point_fields=point_fields, progress=progress)

    def distance(self, curve: Union[CurveLike, Sequence[Curve]], *, closed: bool = False,
                 progress: Any = None, **parameters: Any) -> Distance:
        """talweg.distance() on this mesh."""
        work = Workspace(self, curve, closed=closed, plugin="talweg.distance", **parameters)
        result = work.run(vertex_fields=True, progress=progress)
        total = result.total.more
        return Distance(result.fields["distance"], result.fields["potential"],
                        total["distance_max"], total["potential_max"],
                        tuple(report.slack for report in result.reports if report.slack is not None))
