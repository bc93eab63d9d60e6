"""Meshes that Talweg makes of others, and where everything of them comes from."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, List, Mapping, Optional, Tuple

import numpy as np

from . import _arrays, _given
from ._carrying import Carrier
from ._instance import Instance, Lists
from ._mesh import Mesh
from ._results import Result
from ._types import Array, ArrayLike, Floats, Integers, Progress


@dataclass(frozen=True, eq=False)
class Origin:
    """Where a mesh comes from, in the numbers of the mesh that it was made of.

    Each vertex lies at ``weights`` between ``vertices`` of one triangle; one that was there has
    itself with the weight 1, and one that comes from nowhere (inside a lid) has none.
    """

    vertices: Integers  #: (n, 3); -1 where fewer are needed
    weights: Floats  #: (n, 3), >= 0; their sum is 1, or 0 for vertices from nowhere
    faces: Integers  #: (m,), the face that each is a part of; -1: from nowhere

    def interpolate(self, values: ArrayLike) -> Floats:
        """What has a row for each vertex of the old mesh, for each of the new one: linearly between
        them, and 0 for vertices from nowhere."""
        rows = np.asarray(values, dtype=np.float64)[np.maximum(self.vertices, 0)]
        weights = self.weights.reshape(self.weights.shape + (1,) * (rows.ndim - 2))
        return np.asarray((rows * weights).sum(axis=1))


@dataclass(frozen=True, eq=False)
class Chain:
    """A curve as a chain of vertices along edges of a mesh; each place and the next share an edge
    if they are in this mesh."""

    closed: bool
    length: int  #: how many places it has
    #: (k,), 0 <= place < length, ascending: all of them, once, unless the mesh was taken apart. An
    #: opened seam has two vertices or more at a place; a place that is in another piece has none.
    places: Integers
    vertices: Integers  #: (k,), a vertex at each of these


class MadeMesh(Mesh):
    """A mesh that was made of another one: a ``Mesh`` with attributes carried over and its origin.

    It is opened when it is first used.
    """

    origin: Origin  #: where it comes from
    chains: List[Chain]  #: one for each curve


def run(mesh: Mesh, instance: Instance, carry: Optional[Mapping[str, str]],
        fields: Tuple[bool, bool], progress: Optional[Progress]) -> Result:
    """A run of any plugin, with the meshes that it makes.

    :param fields: whether those of points and of vertices are wanted.
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
    """The meshes of the instance's last run."""
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


def _origin_of(given: Any, limits: _given.Limits) -> Any:
    origin = Origin(_arrays.copied_indices(given.vertices).reshape(-1, 3),
                    _arrays.copied(given.weights).reshape(-1, 3),
                    _arrays.copied_indices(given.triangles))
    _given.check_origin(origin, limits)
    closed, lengths = _arrays.copied(given.closed), _arrays.copied(given.lengths)
    rows = _arrays.copied_indices(given.chains).reshape(-1, 3)
    bounds = np.searchsorted(rows[:, 0], np.arange(given.curve_count + 1))
    chains = [Chain(bool(closed[k]), int(lengths[k]), rows[first:last, 1], rows[first:last, 2])
              for k, (first, last) in enumerate(zip(bounds[:-1], bounds[1:]))]
    return origin, chains
