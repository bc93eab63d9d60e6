"""Meshes that Talweg makes from others, with the origin of their vertices and faces."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, List, Mapping, Optional, Tuple

import numpy as np

from . import _arrays, _result_checks
from ._carrying import Carrier
from ._instance import Instance, Lists
from ._mesh import Mesh
from ._results import Result
from ._types import Array, ArrayLike, Floats, Integers, Progress


@dataclass(frozen=True, eq=False)
class Origin:
    """The origin of a made mesh in the original mesh.

    Each vertex is the combination of ``vertices`` of one original triangle with ``weights``. An original
    vertex has itself with the weight 1; a vertex inside a lid has no origin, and weights of 0.
    """

    vertices: Integers  #: (n, 3), original vertices; -1 for fewer than three
    weights: Floats  #: (n, 3), >= 0; rows sum to 1, or to 0 without an origin
    faces: Integers  #: (m,), the original face that each is a part of; -1: none

    def interpolate(self, values: ArrayLike) -> Floats:
        """Interpolates values (vertices of the original, ...) linearly to the made mesh, (n, ...); 0 at
        vertices without an origin."""
        rows = np.asarray(values, dtype=np.float64)[np.maximum(self.vertices, 0)]
        weights = self.weights.reshape(self.weights.shape + (1,) * (rows.ndim - 2))
        return np.asarray((rows * weights).sum(axis=1))


@dataclass(frozen=True, eq=False)
class Chain:
    """A curve as a chain of vertices along edges of a made mesh. Consecutive places share an edge if both are
    in this mesh."""

    closed: bool
    length: int  #: number of places along the curve
    #: (k,), 0 <= place < length, ascending. A cut mesh has each place once; an opened seam has two or more
    #: vertices at a place; a piece lacks the places in other pieces.
    places: Integers
    vertices: Integers  #: (k,), the vertex for each entry of ``places``


class MadeMesh(Mesh):
    """A mesh that was made from another one: a ``Mesh`` with interpolated attributes and its origin.

    It is opened at its first use.
    """

    origin: Origin  #: the origin of its vertices and faces
    chains: List[Chain]  #: a chain for each curve


def run(mesh: Mesh, instance: Instance, carry: Optional[Mapping[str, str]],
        fields: Tuple[bool, bool], progress: Optional[Progress]) -> Result:
    """Runs a plugin and returns its result with the meshes that it made.

    :param fields: whether fields of points, and of vertices, are requested.
    """
    point_fields, vertex_fields = fields
    carrier = Carrier(mesh, instance, carry) if instance.takes_attributes() else None
    result, lists = instance.run_with_meshes(vertex_fields, progress, point_fields)
    made: List[Mesh] = []
    if carrier is not None:
        made.extend(made_meshes(instance, carrier, lists))
    for vertices, faces in lists if carrier is None else []:
        plain = Mesh.__new__(Mesh)
        plain.__setstate__({"vertices": vertices, "faces": faces, "repair_steps": False,
                            "vertex_attributes": {}, "face_attributes": {}, "corner_attributes": {}})
        made.append(plain)
    return replace(result, meshes=made)


def made_meshes(instance: Instance, carrier: Carrier, lists: List[Lists]) -> List[MadeMesh]:
    """The meshes of the instance's last run, with attributes and origins."""
    return [_made(instance, carrier, number, vertices, faces)
            for number, (vertices, faces) in enumerate(lists)]


def _made(instance: Instance, carrier: Carrier, number: int, vertices: Array,
          faces: Array) -> MadeMesh:
    came: List[Any] = []
    instance.take_origin(number, lambda origin: came.append(_origin_of(origin, instance.limits)))
    origin, chains = came[0]
    at_vertices, at_faces, at_corners = carrier.of_mesh(number)
    mesh = MadeMesh.__new__(MadeMesh)
    mesh.__setstate__({"vertices": vertices, "faces": faces, "repair_steps": False,
                       "vertex_attributes": at_vertices, "face_attributes": at_faces,
                       "corner_attributes": at_corners, "face_names": dict(carrier.face_names),
                       "references": list(carrier.references), "frame": carrier.frame, "origin": origin, "chains": chains})
    return mesh


def _origin_of(given: Any, limits: _result_checks.Limits) -> Any:
    origin = Origin(_arrays.copied_indices(given.vertices).reshape(-1, 3),
                    _arrays.copied(given.weights).reshape(-1, 3),
                    _arrays.copied_indices(given.triangles))
    _result_checks.check_origin(origin, limits)
    closed, lengths = _arrays.copied(given.closed), _arrays.copied(given.lengths)
    rows = _arrays.copied_indices(given.chains).reshape(-1, 3)
    bounds = np.searchsorted(rows[:, 0], np.arange(given.curve_count + 1))
    chains = [Chain(bool(closed[k]), int(lengths[k]), rows[first:last, 1], rows[first:last, 2])
              for k, (first, last) in enumerate(zip(bounds[:-1], bounds[1:]))]
    return origin, chains
