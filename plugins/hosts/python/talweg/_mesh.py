"""Triangle meshes, opened once and shared."""

from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING, Any, Dict, Mapping, Optional, Sequence, Union

from . import _arrays, _attributes, _convert, _mesh_files, _plugins, _repair_steps, _vtk
from ._attributes import Parts
from ._curves import Curve, CurveLike, as_curve
from ._errors import BadMesh, BadUsage
from ._files import Path
from ._instance import Instance
from ._interruptible import as_progress
from ._results import Distance, Result
from ._types import ArrayLike
from ._version import __version__
from ._workspace import OneOrEach, Workspace

if TYPE_CHECKING:
    from ._pipeline import Cut, Labels, Measurement, Repair


class Mesh:
    """An opened triangle mesh: checked and copied once, then shared by all workspaces on it.

    :param vertices: (n, 3) real numbers, float64 or float32, mesh units. Or, without ``faces``, a
        pair (vertices, faces), a file as for read_mesh(), or a mesh of trimesh, meshio, VTK
        (``vtkPolyData``), PyVista or vedo, with its attributes; polygons become triangles.
    :param faces: (m, 3) whole numbers, counterclockwise from outside.
    :param vertex_attributes: arrays of numbers by name, of shape (n, ...).
    :param face_attributes: arrays by name, (m, ...) each.
    :param corner_attributes: arrays by name, (m, 3, ...) each: a row for each corner of each face.
    :param repair: True, or some of the steps "weld", "drop", "orient" and "split" as "weld,drop": the mesh is
        repaired to a surface when it is opened. Curves, results and attributes keep the numbering of the
        given arrays.
    :raises BadMesh: if the mesh is not an oriented manifold; the sentence says where.
    :raises BadUsage: for an attribute of another shape, or one without numbers.

    Arrays of float32, float64, and 32- and 64-bit integers with any stride of rows are not copied in Python;
    each plugin reads them at its first use, so leave them unchanged. Any thread may use the mesh; a workspace
    belongs to one thread at a time. A pickled mesh is opened again at its first use.
    """

    def __init__(self, vertices: Any, faces: Optional[ArrayLike] = None, *,
                 vertex_attributes: Optional[Mapping[str, ArrayLike]] = None,
                 face_attributes: Optional[Mapping[str, ArrayLike]] = None,
                 corner_attributes: Optional[Mapping[str, ArrayLike]] = None,
                 repair: Union[None, bool, str] = None, progress: Any = None,
                 plugin: str = "talweg.smooth") -> None:
        #: The repair at the opening of the mesh: False, True, or steps such as "weld=1e-4,drop"
        self.repair_steps = _repair_steps.checked(repair)
        parts = _parts_of(vertices) if faces is None else Parts(vertices, faces)
        self.vertices = _arrays.readable(parts.vertices, 3, "The mesh's vertices", BadMesh)
        self.faces = _arrays.readable(parts.faces, 3, "The mesh's faces", BadMesh)
        self._keep_attributes({**parts.vertex_attributes, **(vertex_attributes or {})},
                              {**parts.face_attributes, **(face_attributes or {})},
                              {**parts.corner_attributes, **(corner_attributes or {})})
        #: Texts for the numbers of a face attribute, by the attribute's name: groups and materials of OBJ
        #: files ("g", "o", "usemtl", "s")
        self.face_names = {name: list(texts) for name, texts in parts.face_names.items()}
        #: Lines of an OBJ file that name other files: ["mtllib bone.mtl"]
        self.references = list(parts.references)
        #: Unit and space of the coordinates in the mesh's file, for read_curves() and write_curves(): a unit
        #: ("mm"), an anatomical space ("RAS" or "LPS"), both ("mm RAS"), or nothing ("")
        self.frame = parts.frame
        self._begin()
        try:
            self._instance(plugin, progress)
        except BadMesh as error:
            if not _is_path(vertices):
                raise
            raise BadMesh(f"{os.fspath(vertices)}: {error}") from None

    def _keep_attributes(self, at_vertices: Mapping[str, ArrayLike],
                         at_faces: Mapping[str, ArrayLike],
                         at_corners: Mapping[str, ArrayLike]) -> None:
        n, m = len(self.vertices), len(self.faces)
        #: Arrays by name, with a row for each vertex, face, or corner (m, 3, ...); may be changed.
        self.vertex_attributes = _attributes.checked(at_vertices, (n,), "vertex")
        self.face_attributes = _attributes.checked(at_faces, (m,), "face")
        self.corner_attributes = _attributes.checked(at_corners, (m, 3), "corner")

    def _begin(self) -> None:
        self._owners: Dict[str, Instance] = {}
        self._opening = threading.Lock()
        self._closed: Optional[Mesh] = None

    def _as_closed(self) -> Mesh:
        """The same mesh unopened. Results hold this one, which keeps no opened plugin alive."""
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
                     self.corner_attributes, self.face_names, self.references, self.frame)

    def to_trimesh(self) -> Any:
        """A ``trimesh.Trimesh`` with the same numbering. The vertex or face attribute ``colors``
        ((n, 3) or (n, 4) bytes) becomes its colours, the vertex attribute ``uv`` (n, 2) its texture
        coordinates; attributes of corners are in ``metadata["corner_attributes"]``.

        :raises ImportError: without trimesh. :raises BadUsage: for wrong attributes.
        """
        return _convert.to_trimesh(self._parts())

    def to_meshio(self) -> Any:
        """A ``meshio.Mesh`` with point and cell data; attributes of corners are left out.

        :raises ImportError: without meshio. :raises BadUsage: for wrong attributes.
        """
        return _convert.to_meshio(self._parts())

    def to_vtk(self) -> Any:
        """A ``vtkPolyData`` with point and cell data; attributes of corners are field data ``corner:NAME``,
        three rows for each face. Attributes with more than two dimensions are flattened to two.

        :raises ImportError: without VTK 9. :raises BadUsage: for wrong attributes.
        """
        return _vtk.polydata(self._parts())

    def to_pyvista(self) -> Any:
        """A ``pyvista.PolyData`` with the data of to_vtk(). :raises ImportError: without PyVista."""
        return _convert.to_pyvista(self._parts())

    def _instance(self, plugin: str, progress: Any = None) -> Instance:
        """A new instance of the plugin on this mesh."""
        found = _plugins.plugin(plugin)
        with self._opening:
            if plugin not in self._owners:
                owner = Instance(found, __version__)
                _repair_steps.put(owner, self.repair_steps)
                owner.set_mesh(self.vertices, self.faces, as_progress(progress))
                self._owners[plugin] = owner
            instance = Instance(found, __version__)
            _repair_steps.put(instance, self.repair_steps)  # before the mesh is shared: the instance must
                                                            # open it repaired
            instance.share_mesh(self._owners[plugin])
        return instance

    def workspace(self, curves: Union[CurveLike, Sequence[Curve], None] = None, *,
                  closed: bool = False, plugin: str = "talweg.smooth",
                  **parameters: Any) -> "Workspace":
        """A workspace on this mesh; see ``Workspace``."""
        return Workspace(self, curves, closed=closed, plugin=plugin, **parameters)

    def smooth(self, curve: Union[CurveLike, Sequence[Curve]], tau: OneOrEach = 1.0, *,
               closed: bool = False, point_fields: bool = False, vertex_fields: bool = False,
               progress: Any = None, **parameters: Any) -> Result:
        """talweg.smooth() on this mesh."""
        work = Workspace(self, curve, closed=closed, progress=progress)
        return work.smooth(tau, point_fields=point_fields, vertex_fields=vertex_fields,
                           progress=progress, **parameters)

    def draw(self, points: CurveLike, *, closed: bool = False, straight: Optional[bool] = None,
             exact: bool = True, **parameters: Any) -> Curve:
        """talweg.draw() on this mesh."""
        work = Workspace(self, as_curve(points, closed), plugin="talweg.draw",
                         way={None: "auto", True: "straight", False: "edges"}[straight],
                         points="exact" if exact else "rough", **parameters)
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

    def cut(self, curves: Union[CurveLike, Sequence[Curve]], **how: Any) -> Cut:
        """talweg.cut() on this mesh."""
        made: Cut = _pipeline().cut(self, curves, **how)
        return made

    def offset(self, curves: Union[CurveLike, Sequence[Curve]], distance: float,
               **how: Any) -> Result:
        """talweg.offset() on this mesh."""
        made: Result = _pipeline().offset(self, curves, distance, **how)
        return made

    def labels(self, values: Union[str, ArrayLike], **how: Any) -> Labels:
        """talweg.labels() on this mesh."""
        made: Labels = _pipeline().labels(self, values, **how)
        return made

    def measure(self, curves: Union[CurveLike, Sequence[Curve]],
                others: Union[CurveLike, Sequence[Curve], None] = None, **how: Any) -> Measurement:
        """talweg.measure() on this mesh."""
        made: Measurement = _pipeline().measure(self, curves, others, **how)
        return made

    def inspect(self, *, progress: Any = None) -> Dict[str, Any]:
        """talweg.inspect() of the mesh's arrays, without the repair at its opening."""
        made: Dict[str, Any] = _pipeline().inspect(self, progress=progress)
        return made

    def repair(self, steps: Union[bool, str] = True, **how: Any) -> Repair:
        """talweg.repair() of the mesh's arrays, without the repair at its opening."""
        made: Repair = _pipeline().repair(self, steps, **how)
        return made


def _is_path(mesh: Any) -> bool:
    return isinstance(mesh, (str, os.PathLike))


def _parts_of(mesh: Any) -> Parts:
    if _is_path(mesh):
        return _mesh_files.read_parts(mesh)
    if isinstance(mesh, (list, tuple)) and len(mesh) == 2:
        return Parts(*mesh)
    return _convert.parts_of(mesh)


def read_mesh(path: Path, *, repair: Union[None, bool, str] = None, progress: Any = None,
              plugin: str = "talweg.smooth") -> Mesh:
    """Reads a mesh with all attributes of its file, as the driver does: ``Mesh(path)``.

    Related columns form one attribute: ``normals`` (nx, ny, nz), ``colors`` (red, green, blue, alpha), ``uv``
    (s, t), ``NAME`` (NAME_0, NAME_1, ...). The logger ``talweg`` lists data that this and the other functions
    for files leave out.

    :param path: .ply, .obj, .off, .stl, .om, .vtk, .vtp, .msh, .gltf, .glb or .3mf.
    :param repair: as for ``Mesh``.
    :param plugin: the plugin that opens the mesh: "talweg.cut" if the mesh will be cut.
    :raises BadFile: if the file cannot be read; with file, line, and the expected text.
    :raises BadMesh: if the mesh is not a surface; inspect(path) lists all defects.
    """
    return Mesh(path, repair=repair, progress=progress, plugin=plugin)


def write_mesh(path: Path, mesh: Any, *, tag: bool = False) -> None:
    """Writes a mesh with its attributes, with the same bytes as the driver.

    :param path: .ply, .obj, .off, .stl, .vtk or .vtp.
    :param mesh: a ``Mesh``, a pair (vertices, faces), or a mesh of another package; it need not be a surface.
    :param tag: also write the curves of a cut mesh, as edges (.ply, .obj, .vtk, .vtp).
    :raises BadFile: if the file cannot be written; an existing file stays unchanged.
    :raises BadUsage: for an attribute of another shape, or ``tag`` with a mesh that was not cut.
    """
    parts = mesh._parts() if isinstance(mesh, Mesh) else _parts_of(mesh)
    chains = getattr(mesh, "chains", None)
    if tag and chains is None:
        raise BadUsage("tag needs a mesh that was cut.")
    _mesh_files.write_parts(path, parts, chains if tag and chains else ())


def _pipeline() -> Any:
    from . import _pipeline as pipeline  # pylint: disable=import-outside-toplevel,cyclic-import

    return pipeline
