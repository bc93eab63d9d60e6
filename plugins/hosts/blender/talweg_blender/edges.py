"""Edges of a mesh that Talweg made: the old edges in their order, then the new ones."""

from typing import NamedTuple

import numpy as np


def keys(edges, count):
    """A number for each pair of vertices; the order within a pair does not matter."""
    ordered = np.sort(edges.astype(np.int64), axis=1)
    return ordered[:, 0] * count + ordered[:, 1]


def found(wanted, among):
    """For each wanted key the first index in ``among``, or -1."""
    if not len(among):
        return np.full(len(wanted), -1)
    order = np.argsort(among, kind="stable")
    place = np.minimum(np.searchsorted(among[order], wanted), len(among) - 1)
    return np.where(among[order][place] == wanted, order[place], -1)


def between(edges, vertices, count):
    """Indices of the edges with both ends among ``vertices``; ends of -1 are none."""
    marked = np.zeros(count + 1, bool)
    marked[vertices] = True
    marked[-1] = False
    return np.flatnonzero(marked[edges[:, 0]] & marked[edges[:, 1]])


class Edges(NamedTuple):
    ends: np.ndarray  # (k, 2), vertices of the made mesh
    of_loops: np.ndarray  # the edge of each corner of the polygons
    came_from: np.ndarray  # (k,), the old edge that each edge is a part of, or -1


def edges_of(made, layout, saved, loose, became):
    """The edges of the made mesh. Only edges near the curves are searched; all others are copied from the old
    mesh.

    :param loose: old edges without faces: (their indices, their ends (k, 2) as vertices of the made mesh).
    """
    count = len(made.vertices)
    pairs = np.stack([layout.loop_vertices, layout.next_loop_vertices()], -1)
    pairs.sort(axis=1)
    first = _first_ones(saved, became)
    old = np.where(layout.old_loops < 0, -1, first[saved.loop_edges[layout.old_loops]])
    ends = np.full((len(saved.edges), 2), -1, np.int64)
    ends[old[old >= 0]] = pairs[old >= 0]
    ends[first[loose[0]]] = loose[1]
    # An opened seam makes two edges of an old one; the old row holds one of the two.
    known = (old >= 0) & (ends[old] == pairs).all(axis=1) if len(ends) else old >= 0
    others = np.flatnonzero(~known)
    near = between(ends, pairs[others].ravel(), count)
    wanted = keys(pairs[others], count)
    place = found(wanted, keys(ends[near], count))
    new, number = np.unique(wanted[place < 0], return_inverse=True)
    new_ends = np.stack([new // count, new % count], -1)
    kept = np.flatnonzero(ends[:, 0] >= 0)
    number_of = np.cumsum(ends[:, 0] >= 0) - 1
    of_loops = np.zeros(len(old), np.int64)
    of_loops[known] = number_of[old[known]]
    of_loops[others[place >= 0]] = number_of[near[place[place >= 0]]]
    of_loops[others[place < 0]] = len(kept) + number
    return Edges(np.concatenate([ends[kept], new_ends]), of_loops,
                 np.concatenate([kept, _part_of(new_ends, made, saved, became)]))


def _first_ones(saved, became):
    """For each old edge the first old edge with the same ends after a repair has welded vertices."""
    if became is None:
        return np.arange(len(saved.edges))
    _, first, number = np.unique(keys(became[saved.edges], len(became)), return_index=True,
                                 return_inverse=True)
    return first[number]


def _part_of(ends, made, saved, became):
    """The old edge that each edge is a part of, or -1."""
    if became is not None:
        now = became[saved.edges]
        near = between(now, ends.ravel(), len(made.vertices))
        place = found(keys(ends, len(made.vertices)), keys(now[near], len(made.vertices)))
        return np.where(place < 0, -1, near[place]) if len(near) else place
    origin = np.where(made.origin.weights[ends] > 0, made.origin.vertices[ends], -1).reshape(-1, 6)
    low = np.where(origin < 0, np.iinfo(np.int64).max, origin).min(axis=1)
    high = origin.max(axis=1)
    on_edge = ((origin < 0) | (origin == low[:, None]) | (origin == high[:, None])).all(axis=1)
    on_edge &= low < high
    count = saved.vertex_count
    near = between(saved.edges, np.concatenate([low[on_edge], high[on_edge]]), count)
    result = np.full(len(ends), -1)
    place = found(low[on_edge] * count + high[on_edge], keys(saved.edges[near], count))
    result[on_edge] = np.where(place < 0, -1, near[place]) if len(near) else -1
    return result
