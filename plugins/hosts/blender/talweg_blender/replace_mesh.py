"""Replaces the geometry of a mesh object by a mesh that Talweg made, and restores all other data."""

import numpy as np

from . import attributes, edges, polygons


def _loose_edges(saved, made, became):
    """Old edges without faces: their indices, and their ends as vertices of ``made``."""
    loose = np.ones(len(saved.edges), bool)
    loose[saved.loop_edges] = False
    loose = np.flatnonzero(loose)
    if became is None:
        old = polygons.old_vertices(made) if len(loose) else np.empty(0, np.int64)
        became = np.full(saved.vertex_count, -1)
        first = np.flatnonzero(old >= 0)[::-1]  # reversed: of several vertices with one origin the first
                                                # counts
        became[old[first]] = first
    ends = became[saved.edges[loose]].astype(np.int64)
    there = (ends >= 0).all(axis=1) & (ends[:, 0] != ends[:, 1])
    return loose[there], ends[there]


def rewrite(obj, made, saved, arrays, became=None):
    """Replaces the geometry, in object mode. Returns the layout of the polygons, and the index in the mesh of
    each vertex of ``made`` (-1: no face and no edge uses the vertex).

    :param became: after a repair, (n,), the new vertex of each old vertex.
    """
    layout = polygons.layout_of(made, arrays, became)
    all_edges = edges.edges_of(made, layout, saved, _loose_edges(saved, made, became), became)
    kept = np.ones(len(made.vertices), bool)
    if became is not None:  # welding leaves vertices that nothing uses
        kept[:] = False
        kept[made.faces] = True
        kept[all_edges.ends] = True
    vertices = np.flatnonzero(kept)
    place = np.where(kept, np.cumsum(kept) - 1, -1)
    mesh = obj.data
    mesh.clear_geometry()
    mesh.vertices.add(len(vertices))
    attributes.write(mesh.vertices, "co", made.vertices[vertices].astype(np.float32))
    mesh.edges.add(len(all_edges.ends))
    attributes.write(mesh.edges, "vertices", place[all_edges.ends].astype(np.int32))
    mesh.loops.add(len(layout.loop_vertices))
    attributes.write(mesh.loops, "vertex_index", place[layout.loop_vertices].astype(np.int32))
    attributes.write(mesh.loops, "edge_index", all_edges.of_loops.astype(np.int32))
    mesh.polygons.add(len(layout.starts))
    attributes.write(mesh.polygons, "loop_start", layout.starts)
    attributes.write(mesh.polygons, "loop_total", layout.totals)
    mesh.update(calc_edges_loose=True)
    saved.write(obj, made, layout, vertices, all_edges.came_from)
    mesh.update()
    return layout, place


def select_chains(obj, made, place):
    """Selects the edges along the curves and nothing else, in object mode."""
    mesh = obj.data
    along = place[polygons.chain_edges(made)].reshape(-1, 2)
    ends = attributes.read(mesh.edges, "vertices", 2, np.int32)
    count = len(mesh.vertices)
    near = edges.between(ends, along.ravel(), count)
    near = near[edges.found(edges.keys(ends[near], count), edges.keys(along, count)) >= 0]
    chosen = np.zeros(len(ends), bool)
    chosen[near] = True
    marked = np.zeros(count, bool)
    marked[ends[near].ravel()] = True
    attributes.write(mesh.polygons, "select", np.zeros(len(mesh.polygons), bool))
    attributes.write(mesh.edges, "select", chosen)
    attributes.write(mesh.vertices, "select", marked)
