"""A mesh object gets the geometry that Talweg made of it, with all that it had."""

import numpy as np

from . import attributes, polygons


def _keys(edges, count):
    ordered = np.sort(edges.astype(np.int64), axis=1)
    return ordered[:, 0] * count + ordered[:, 1]


def _found(keys, among):
    """The first place of each key among these, or -1."""
    if not len(among):
        return np.full(len(keys), -1)
    order = np.argsort(among, kind="stable")
    place = np.minimum(np.searchsorted(among[order], keys), len(among) - 1)
    return np.where(among[order][place] == keys, order[place], -1)


def _edge_from(edges, made, saved, vertices, became):
    """The old edge that each new one is a part of, or -1."""
    edges = vertices[edges]  # in the numbers of `made`
    if became is not None:
        return _found(_keys(edges, len(made.vertices)), _keys(became[saved.edges], len(made.vertices)))
    origin = np.where(made.origin.weights > 0, made.origin.vertices, -1)[edges].reshape(-1, 6)
    low, high = np.where(origin < 0, np.iinfo(np.int64).max, origin).min(axis=1), origin.max(axis=1)
    on_edge = ((origin < 0) | (origin == low[:, None]) | (origin == high[:, None])).all(axis=1)
    count = int(max(made.origin.vertices.max(initial=0), saved.edges.max(initial=0))) + 1
    place = _found(low * np.int64(count) + high, _keys(saved.edges, count))
    return np.where(on_edge & (low < high), place, -1)


def _loose_edges(saved, made, arrays, became):
    """Edges without faces, in the numbers of `made`."""
    count = len(arrays.vertices)
    ends = np.stack([arrays.loop_vertices, arrays.next_loop_vertices()], -1)
    loose = saved.edges[_found(_keys(saved.edges, count), _keys(ends, count)) < 0]
    if became is not None:
        loose = became[loose]
        return loose[loose[:, 0] != loose[:, 1]]
    place = np.full(count, -1)
    whole = np.flatnonzero(made.origin.weights.max(axis=1, initial=0) == 1)
    old = made.origin.vertices[whole, made.origin.weights[whole].argmax(axis=1)]
    place[old[::-1]] = whole[::-1]  # the first
    loose = place[loose]
    return loose[(loose >= 0).all(axis=1)]


def rewrite(obj, made, saved, arrays, became=None):
    """In object mode. Returns the layout of its polygons, and the places of ``made.vertices`` in the
    mesh (-1: no face or edge has it any more).

    :param became: of a repair, the new vertex of each old one.
    """
    layout = polygons.layout_of(made, arrays)
    loose = _loose_edges(saved, made, arrays, became)
    kept = np.ones(len(made.vertices), bool)
    if became is not None:  # vertices that were welded onto others are left over
        kept = np.bincount(np.concatenate([made.faces.ravel(), loose.ravel()]).astype(np.int64),
                           minlength=len(made.vertices)) > 0
    vertices = np.flatnonzero(kept)
    place = np.where(kept, np.cumsum(kept) - 1, -1)
    mesh = obj.data
    mesh.clear_geometry()
    mesh.vertices.add(len(vertices))
    attributes.write(mesh.vertices, "co", made.vertices[vertices].astype(np.float32))
    mesh.edges.add(len(loose))
    attributes.write(mesh.edges, "vertices", place[loose].astype(np.int32))
    mesh.loops.add(len(layout.loop_vertices))
    attributes.write(mesh.loops, "vertex_index", place[layout.loop_vertices].astype(np.int32))
    mesh.polygons.add(len(layout.starts))
    attributes.write(mesh.polygons, "loop_start", layout.starts)
    attributes.write(mesh.polygons, "loop_total", layout.totals)
    mesh.update(calc_edges=True, calc_edges_loose=True)
    edges = attributes.read(mesh.edges, "vertices", 2, np.int32)
    saved.write(obj, made, layout, vertices, _edge_from(edges, made, saved, vertices, became))
    mesh.update()
    return layout, place


def select_chains(obj, made, place):
    """Selects the edges along the curves and nothing else. In object mode."""
    mesh = obj.data
    along = place[polygons.chain_edges(made)].reshape(-1, 2)
    edges = attributes.read(mesh.edges, "vertices", 2, np.int32)
    count = len(mesh.vertices)
    chosen = _found(_keys(edges, count), _keys(along, count)) >= 0
    marked = np.zeros(count, bool)
    marked[edges[chosen].ravel()] = True
    attributes.write(mesh.polygons, "select", np.zeros(len(mesh.polygons), bool))
    attributes.write(mesh.edges, "select", chosen)
    attributes.write(mesh.vertices, "select", marked)
