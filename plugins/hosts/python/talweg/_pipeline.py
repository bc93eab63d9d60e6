"""Cuts, borders of labels, measures, inspection and repair."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

import numpy as np

from . import _repair_steps
from ._carrying import Carrier
from ._curves import Curve, CurveLike, as_curves
from ._errors import BadMesh, BadUsage
from ._interruptible import as_progress
from ._made import MadeMesh, made_meshes
from ._mesh import Mesh
from ._results import Report, Result
from ._types import Array, ArrayLike, Integers
from ._workspace import Workspace

Tree = Dict[str, Any]


def mesh_of(given: Any, plugin: str) -> Mesh:
    """A Mesh unchanged; a pair (vertices, faces), a file, or a mesh of another package, opened for the
    plugin."""
    return given if isinstance(given, Mesh) else Mesh(given, plugin=plugin)


def tree_of(report: Report) -> Tree:
    """A report in the form of the driver's JSON: groups become dictionaries, numbered groups lists, and
    infinite numbers None."""
    entries = {name: value for name, value in vars(report).items()
               if name not in ("more", "time_ms") and value not in (None, ())}
    lists = ["warnings", "decisive", "decisive_at"] if report.termination else ["warnings"]
    entries.update({name: () for name in lists if getattr(report, name) == ()})
    entries.update(report.more)
    entries.update({"time_ms." + name: value for name, value in report.time_ms.items()})
    root: Tree = {}
    for key, value in entries.items():
        node: Tree = root
        *groups, last = key.split(".")
        for group in groups:
            below = node.get(group)
            if not isinstance(below, dict):  # the report has an empty list under this key
                below = node[group] = {}
            node = below
        node[last] = _finite(value)
    return {name: _listed(value) for name, value in root.items()}


def _finite(value: Any) -> Any:
    """None for infinite numbers, which stand for "not bounded" and "not measured", as in the driver's
    JSON."""
    if isinstance(value, tuple):
        return [_finite(one) for one in value]
    return None if isinstance(value, float) and math.isinf(value) else value


def _listed(node: Any) -> Any:
    if not isinstance(node, dict):
        return node
    below = {name: _listed(value) for name, value in node.items()}
    if below and all(name.isdigit() for name in below):
        return [below[name] for name in sorted(below, key=int)]
    return below


@dataclass(frozen=True, eq=False, repr=False)
class Cut:
    """The result of talweg.cut()."""

    meshes: List[MadeMesh]  #: one mesh, or one for each piece, ordered by lowest face
    report: Tree  #: counts and measures of the cut, and of each piece

    def __repr__(self) -> str:
        return f"<talweg.Cut: {self.meshes}>"

    @property
    def mesh(self) -> MadeMesh:
        """The only mesh. :raises BadUsage: if there are several meshes, or none."""
        if len(self.meshes) != 1:
            raise BadUsage(f"The cut has {len(self.meshes)} meshes, so it has no .mesh; .meshes lists them.")
        return self.meshes[0]


@dataclass(frozen=True, eq=False, repr=False)
class Labels:
    """The result of talweg.labels()."""

    borders: List[Curve]  #: the smoothed borders
    left: Integers  #: (number of borders,), the label on the left of each border, seen from outside
    right: Integers
    labels: Integers  #: (number of faces,), for each face the label of its larger part
    #: The mesh cut along the borders; its face attribute "label" has the exact labels
    mesh: Optional[MadeMesh]
    reports: List[Report]  #: a report for each border
    report: Tree  #: totals, and entries for each border and each region, as the driver's --report

    def __repr__(self) -> str:
        return f"<talweg.Labels: {len(self.borders)} borders>"


@dataclass(frozen=True)
class Measurement:
    """The result of talweg.measure(), in mesh units and radians."""

    curves: List[Tree]  #: the measures of each curve
    total: Tree  #: the measures of all curves together; as the driver's --report


@dataclass(frozen=True, eq=False, repr=False)
class Repair:
    """The result of talweg.repair()."""

    mesh: MadeMesh  #: the surface; its ``origin`` maps back to the given mesh
    became: Integers  #: (number of vertices,): the new vertex of each given one; of several copies the first
    became_face: Integers  #: (number of faces,): the new face of each given one; -1: dropped
    report: Tree  #: the inspection; "repair" has the changes and the verdict after them

    def __repr__(self) -> str:
        return f"<talweg.Repair: {self.mesh}>"

    @property
    def changes(self) -> List[str]:
        """The changes, a sentence each."""
        return list(self.report["repair"]["changes"])


def cut(mesh: Any, curves: Union[CurveLike, Sequence[Curve]], *, closed: bool = False,
        carry: Optional[Mapping[str, str]] = None, progress: Any = None, **parameters: Any) -> Cut:
    """Makes curves edges of the mesh, exactly, and on request takes the mesh apart along them.

    No vertex moves; new vertices lie on edges and in faces. Attributes of the mesh are interpolated.

    :param mesh: a ``Mesh``, a pair (vertices, faces), a file, or a mesh of another package.
    :param curves: as for smooth(), but vertices need not be neighbours, and curves may cross.
    :param carry: from the name of an attribute to the rule for its values at new vertices: "linear",
        "rounded", "nearest", or "direction" (unit vectors). By default real numbers are linear; bytes
        (colours) are rounded; other whole numbers and names with "label" are nearest; three columns of real
        numbers with the name "normal" or "normals" are directions; whole numbers at corners are rounded.
    :param parameters: ``open`` (two sides of vertices), ``split`` (a mesh for each piece), ``keep`` ("both",
        "left", "right"), ``cap`` ("none", "auto", "planar", "least-area"), ``merge``, ``border`` ("snap":
        ends of opened seams near the border are extended to it; "leave").
    :raises BadMesh, BadCurve, BadUsage: if the input is wrong; the sentence says what is wrong, and where.
    """
    work = Workspace(mesh_of(mesh, "talweg.cut"), curves, closed=closed, plugin="talweg.cut",
                     **parameters)
    carrier = Carrier(work.mesh, work._instance, carry)
    result, lists = work._instance.run_with_meshes(False, as_progress(progress))
    return Cut(made_meshes(work._instance, carrier, lists), tree_of(result.total))


def labels(mesh: Any, values: Union[str, ArrayLike], *, of: Optional[str] = None,
           cut_mesh: bool = True, carry: Optional[Mapping[str, str]] = None, progress: Any = None,
           **parameters: Any) -> Labels:
    """Smooths all borders of a segmentation together: no border crosses another, no region is lost.

    :param mesh: as for cut().
    :param values: (m,) or (n,) whole numbers, the labels of faces or vertices; or the name of an
        attribute of the mesh.
    :param of: "faces" or "vertices", the owners of the labels; needed if the mesh has as many faces as
        vertices.
    :param cut_mesh: False: ``mesh`` is None, which takes less time.
    :param carry: as for cut().
    :param parameters: ``tau``, ``slack``, ``max_deviation``, ``junctions`` ("fixed", "free"), ``ends``
        ("stay", "slide").
    :raises BadMesh, BadUsage: if the input is wrong; the sentence says what is wrong, and where.
    """
    opened = mesh_of(mesh, "talweg.labels")
    name = {"faces": "triangle_labels", "vertices": "vertex_labels"}[_element(opened, values, of)]
    work = Workspace(opened, plugin="talweg.labels",
                     **{**parameters, name: _values(opened, values, name)})
    if not cut_mesh:
        result = work._instance.run(False, True, as_progress(progress))
        return _labels(result, None)
    carrier = Carrier(opened, work._instance, carry)
    result, lists = work._instance.run_with_meshes(True, as_progress(progress))
    return _labels(result, made_meshes(work._instance, carrier, lists)[0])


def _element(mesh: Mesh, values: Union[str, ArrayLike], of: Optional[str]) -> str:
    if of not in (None, "faces", "vertices"):
        raise BadUsage(f"of must be faces or vertices, not {of!r}.")
    if of is not None:
        return of
    if isinstance(values, str):
        if values not in mesh.face_attributes and values not in mesh.vertex_attributes:
            raise BadUsage(f"The mesh has no attribute {values} of faces or vertices.")
        return "faces" if values in mesh.face_attributes else "vertices"
    return "vertices" if np.shape(values)[:1] == (len(mesh.vertices),) != (
        len(mesh.faces),) else "faces"


def _values(mesh: Mesh, values: Union[str, ArrayLike], name: str) -> ArrayLike:
    if not isinstance(values, str):
        return values
    attributes = mesh.face_attributes if name == "triangle_labels" else mesh.vertex_attributes
    if values not in attributes:
        raise BadUsage(f"The mesh has no such attribute: {values}.")
    return attributes[values]


def _labels(result: Result, mesh: Optional[MadeMesh]) -> Labels:
    report = tree_of(result.total)
    borders = report.get("borders", [])
    sides = [np.array([border[side] for border in borders], np.int64) for side in ("left", "right")]
    return Labels(result.curves, sides[0], sides[1], _whole(result.fields["labels"]), mesh,
                  result.reports, report)


def _whole(values: Array) -> Integers:
    return values.astype(np.int64)


def measure(mesh: Any, curves: Union[CurveLike, Sequence[Curve]],
            others: Union[CurveLike, Sequence[Curve], None] = None, *, closed: bool = False,
            edge: Optional[float] = None, progress: Any = None) -> Measurement:
    """Length, geodesic curvature, bending and self-contacts of curves, and their distances along the surface
    to and from other curves.

    :param mesh: as for cut(). :param curves: as for cut().
    :param others: curves to compare with. If they are as many as ``curves``, they are compared in pairs;
        otherwise all together.
    :param edge: length of the windows for turning, mesh units, > 0. None: the mean edge near each curve. Set
        the same value for curves that you compare.
    :param closed: curves and others that are arrays are loops.
    :raises BadMesh, BadCurve, BadUsage: if the input is wrong; the sentence says what is wrong, and where.
    """
    compared = [] if others is None else as_curves(others, closed)
    work = Workspace(mesh_of(mesh, "talweg.measure"), as_curves(curves, closed) + compared,
                     plugin="talweg.measure", others=len(compared), edge=edge)
    result = work._instance.run(False, False, as_progress(progress))
    return Measurement([tree_of(report) for report in result.reports], tree_of(result.total))


def offset(mesh: Any, curves: Union[CurveLike, Sequence[Curve]], distance: float, *,
           closed: bool = False, progress: Any = None, **parameters: Any) -> Result:
    """Curves at an exact distance along the surface from given curves: margins, bands, guides.

    :param mesh: as for cut(). :param curves: as for cut().
    :param distance: > 0, mesh units.
    :param closed: curves that are arrays are loops.
    :param parameters: ``side`` ("both", "left", "right" of the curve, seen from outside), ``caps``
        ("round": around the ends of an open curve, "none"), ``count`` (also at twice the distance,
        three times, ...), ``tolerance`` (mesh units, between two points), ``ends``.
    :returns: a curve for each component. Its report has ``more``: "distance", "side", "along" (the
        number of the given curve) and "distance_off_max" (mesh units).
    :raises BadUsage: if no point is at this distance; the sentence has the largest distance.
    :raises BadMesh, BadCurve: if the input is wrong; the sentence says what is wrong, and where.
    """
    work = Workspace(mesh_of(mesh, "talweg.offset"), curves, closed=closed, plugin="talweg.offset",
                     distance=distance, **parameters)
    return work.run(progress=progress)


def inspect(mesh: Any, *, progress: Any = None) -> Tree:
    """Size, components and defects of a mesh, and whether curves can be drawn on it.

    :param mesh: as for cut(); it need not be a surface.
    :returns: the entries of ``talweg info --json``: "verdict" ("usable", "repairable", ...), "reason",
        "repair_steps", "defects", "components", "edge_length_mean", ...
    """
    found = tree_of(_inspected(mesh, {"repair": False}, progress)[0].total)
    del found["warnings"]  # an inspection gives none
    return found


def repair(mesh: Any, steps: Union[bool, str] = True, *, progress: Any = None,
           carry: Optional[Mapping[str, str]] = None) -> Repair:
    """Repairs a mesh to a surface; only welding moves vertices.

    Vertices keep their numbers: copies come last, and vertices without faces stay.

    :param mesh: as for cut(); it need not be a surface. Attributes are copied to the new vertices and faces.
    :param steps: True, or some of "weld", "drop", "orient" and "split" as "weld,drop"; with
        "weld=1e-4" vertices within 1e-4 mesh units of others are welded, too.
    :raises BadMesh: if the mesh is not a surface after these steps.
    """
    chosen = _repair_steps.checked(steps)
    if not chosen:
        raise BadUsage("repair() needs one step or more.")
    result, meshes = _inspected(mesh, _repair_steps.values(chosen), progress, True, carry)
    report = tree_of(result.total)
    verdict = report["repair"] if meshes else report
    if not meshes or verdict["verdict"] != "usable":
        raise BadMesh(verdict["reason"])
    return Repair(meshes[0], _whole(result.fields["became"]),
                  _whole(result.fields["became_triangle"]), report)


def _inspected(mesh: Any, parameters: Dict[str, Any], progress: Any, wanted: bool = False,
               carry: Optional[Mapping[str, str]] = None) -> Any:
    given = mesh_of(mesh, "talweg.repair")
    work = Workspace(given, plugin="talweg.repair", **parameters)
    if not wanted:
        return work._instance.run(False, False, as_progress(progress)), []
    carrier = Carrier(given, work._instance, carry)
    result, lists = work._instance.run_with_meshes(True, as_progress(progress))
    return result, made_meshes(work._instance, carrier, lists)
