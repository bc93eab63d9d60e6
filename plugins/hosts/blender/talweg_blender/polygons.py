"""Joins the triangles of a mesh that Talweg made into polygons."""

from typing import NamedTuple

import numpy as np

from . import sound_polygons


class Layout:
    """Polygons with their corners: ``starts`` and ``totals`` (k,) as in Blender; ``loop_vertices`` and
    ``loop_from``, for each corner its vertex and its corner of the triangles, 3 * triangle + 0, 1 or 2;
    ``old_loops``, the old corner, or -1; ``polygon_from``, the old polygon of each polygon, or -1; ``triangle_of``,
    a triangle of each polygon."""

    def __init__(self, whole, parts, faces):
        loops = [np.array(part.corners, np.int64) for part in parts]
        self.totals = np.concatenate([whole.totals, [len(loop) for loop in loops]]).astype(np.int32)
        self.starts = (np.cumsum(self.totals) - self.totals).astype(np.int32)
        self.loop_from = np.concatenate([whole.corners, *loops])
        self.old_loops = np.full(len(self.loop_from), -1)
        self.old_loops[:len(whole.old_loops)] = whole.old_loops
        self.loop_vertices = faces.reshape(-1)[self.loop_from].astype(np.int32)
        self.polygon_from = np.concatenate([whole.polygons, [part.polygon for part in parts]]) \
            .astype(np.int64)
        self.triangle_of = self.loop_from[self.starts] // 3

    def next_loop_vertices(self):
        """The vertex of the next corner of each corner's polygon."""
        following = np.arange(1, len(self.loop_vertices) + 1)
        following[self.starts + self.totals - 1] = self.starts
        return self.loop_vertices[following]


def chain_edges(made):
    """Pairs of vertices along the curves, (k, 2); both sides of opened seams."""
    keys = [np.empty((0, 2), np.int64)]
    for chain in made.chains:
        at = [chain.vertices[chain.places == place] for place in range(chain.length)] \
            if len(chain.places) != chain.length else chain.vertices[:, None]
        following = [*at[1:], *(at[:1] if chain.closed else [])]
        for here, there in zip(at, following):
            keys.append(np.array([(a, b) for a in here for b in there], np.int64).reshape(-1, 2))
    return np.concatenate(keys)


def layout_of(made, arrays, became=None):
    """The polygons of the made mesh. Old polygons that neither curves nor a repair changed stay. The parts of
    the others between the curves become one polygon each where their outline allows it.

    :param became: after a repair, (n,), the new vertex of each old vertex.
    """
    source = made.origin.faces
    separators = np.sort(chain_edges(made), axis=1)
    whole = _Whole(made, arrays, _unchanged(made, arrays, separators, became))
    polygon = np.where(source >= 0, arrays.polygons[source], -1)
    touched = np.flatnonzero((polygon < 0) | ~whole.mask[polygon])
    parts = _parts(made, polygon, touched, {tuple(edge) for edge in separators.tolist()})
    return Layout(whole, parts, made.faces)


def _unchanged(made, arrays, separators, became):
    """Whether each old polygon is unchanged, (number of polygons,): all its triangles exist, with the same
    vertices."""
    source, count = made.origin.faces, len(arrays.triangles)
    own = np.flatnonzero(source >= 0)
    place = np.full(count, -1)
    place[source[own]] = own
    good = np.bincount(source[own], minlength=count) == 1
    if became is not None:
        good &= (made.faces[place] == became[arrays.triangles]).all(axis=1)
    else:
        good &= (old_vertices(made)[made.faces[place]] == arrays.triangles).all(axis=1)
    good[source[_on_curve(made, separators)]] = False  # a curve along a diagonal divides a polygon
    result = np.ones(arrays.polygon_count, bool)
    result[arrays.polygons[~good]] = False
    return result


def old_vertices(made):
    """For each vertex of the made mesh the old vertex that it is; -1 for new vertices."""
    rows = np.arange(len(made.vertices))
    heaviest = made.origin.weights.argmax(axis=1)
    return np.where(made.origin.weights[rows, heaviest] == 1,
                    made.origin.vertices[rows, heaviest], -1)


def _on_curve(made, separators):
    """The triangles with an edge along a curve."""
    marked = np.zeros(len(made.vertices), bool)
    marked[separators.ravel()] = True
    near = np.flatnonzero(marked[made.faces].sum(axis=1) > 1)
    n = len(made.vertices)
    ends = np.sort(np.stack([made.faces[near], np.roll(made.faces[near], -1, axis=1)], -1), axis=-1)
    cuts = separators[:, 0] * n + separators[:, 1]
    return near[np.isin(ends[..., 0] * n + ends[..., 1], cuts).any(axis=1)]


class _Whole:
    """The unchanged polygons with their old corners."""

    def __init__(self, made, arrays, mask):
        self.mask = mask
        own = np.flatnonzero(made.origin.faces >= 0)
        corner = np.zeros(len(arrays.loop_vertices), np.int64)
        corner[arrays.loops[made.origin.faces[own]]] = 3 * own[:, None] + np.arange(3)
        self.polygons = np.flatnonzero(mask)
        self.totals = arrays.totals[self.polygons]
        before = np.cumsum(self.totals) - self.totals
        self.old_loops = np.repeat(arrays.starts[self.polygons] - before, self.totals) \
            + np.arange(self.totals.sum())
        self.corners = corner[self.old_loops]


class Part(NamedTuple):
    """A polygon of the made mesh: a part of an old polygon, or a single triangle."""

    corners: list
    triangles: list
    polygon: int  # the old polygon; -1: none


def _parts(made, polygon, touched, separators):
    order = touched[np.argsort(polygon[touched], kind="stable")]
    bounds = np.flatnonzero(np.diff(polygon[order])) + 1
    found = []
    for triangles in np.split(order, bounds) if len(order) else ():
        number, triangles = int(polygon[triangles[0]]), triangles.tolist()
        if number < 0 or len(triangles) == 1:
            found += _single(triangles, number)
        else:
            found += _joined(made.faces, triangles, separators, number)
    return sound_polygons.without_repetitions(made, touched, found, _single)


def _single(triangles, polygon):
    return [Part([3 * t, 3 * t + 1, 3 * t + 2], [t], polygon) for t in triangles]


def _joined(faces, triangles, separators, polygon):
    """Joins triangles of the same old polygon across edges without a curve; triangles whose outline is not a
    single loop stay single."""
    half = {}
    for t in triangles:
        for k in range(3):
            half[int(faces[t, k]), int(faces[t, (k + 1) % 3])] = 3 * t + k
    parent = {t: t for t in triangles}

    def root(t):
        while parent[t] != t:
            t = parent[t]
        return t

    def is_inside(a, b):
        return (b, a) in half and (min(a, b), max(a, b)) not in separators

    for (a, b), corner in half.items():
        if is_inside(a, b):
            parent[root(corner // 3)] = root(half[b, a] // 3)
    parts = {}
    for t in triangles:
        parts.setdefault(root(t), []).append(t)
    rims = {part: {} for part in parts}
    simple = {part: len(half) == 3 * len(triangles) for part in parts}
    for (a, b), corner in half.items():
        if not is_inside(a, b):
            part = root(corner // 3)
            simple[part] &= a not in rims[part]
            rims[part][a] = (b, corner)
    found = []
    for part, members in parts.items():
        loop = _around(rims[part]) if simple[part] else None
        found += [Part(loop, members, polygon)] if loop else _single(members, polygon)
    return found


def _around(rim):
    """The corners of an outline in order; None if it has several loops."""
    at, loop = next(iter(rim)), []
    while len(loop) < len(rim):
        if at not in rim:
            return None
        at, corner = rim[at]
        if loop and corner == loop[0]:
            return None
        loop.append(corner)
    return loop
