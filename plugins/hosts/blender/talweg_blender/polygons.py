"""Polygons of a mesh that Talweg made of the triangles of one with polygons."""

import numpy as np


class Layout:
    """Polygons with their corners: ``starts`` and ``totals`` (k,) as Blender has them;
    ``loop_vertices`` and ``loop_from``, each corner's vertex and its corner of the triangles, counted
    through them; ``polygon_from``, the old polygon of each, or -1; ``triangle_of``, a triangle of
    each."""

    def __init__(self, loops, polygon_from, faces):
        self.totals = np.array([len(loop) for loop in loops], np.int32)
        self.starts = (np.cumsum(self.totals) - self.totals).astype(np.int32)
        self.loop_from = np.concatenate(loops) if loops else np.empty(0, np.int64)
        self.loop_vertices = faces.reshape(-1)[self.loop_from].astype(np.int32)
        self.polygon_from = np.asarray(polygon_from, np.int64)
        self.triangle_of = self.loop_from[self.starts] // 3


def chain_edges(made):
    """Pairs of vertices along the curves, (k, 2); with both sides of opened seams."""
    keys = [np.empty((0, 2), np.int64)]
    for chain in made.chains:
        at = [chain.vertices[chain.places == place] for place in range(chain.length)] \
            if len(chain.places) != chain.length else chain.vertices[:, None]
        following = [*at[1:], *(at[:1] if chain.closed else [])]
        for here, there in zip(at, following):
            keys.append(np.array([(a, b) for a in here for b in there], np.int64).reshape(-1, 2))
    return np.concatenate(keys)


def layout_of(made, arrays):
    """The old polygons where they are as they were; where the curves or a repair changed them, what
    is left of each between the curves, as one polygon where it can be one."""
    faces, source = made.faces, made.origin.faces
    separators = {tuple(edge) for edge in np.sort(chain_edges(made), axis=1).tolist()}
    polygon = np.where(source >= 0, arrays.polygons[source], -1)
    whole = _unchanged(made, arrays, separators)
    loops, polygon_from = _whole_ones(made, arrays, whole)
    touched = np.flatnonzero((polygon < 0) | ~whole[polygon])
    order = touched[np.argsort(polygon[touched], kind="stable")]
    bounds = np.flatnonzero(np.diff(polygon[order])) + 1
    for triangles in np.split(order, bounds) if len(order) else ():
        number = int(polygon[triangles[0]])
        found = [[3 * t, 3 * t + 1, 3 * t + 2] for t in triangles.tolist()] if number < 0 \
            else _joined(faces, triangles.tolist(), separators)
        loops += [np.array(loop, np.int64) for loop in found]
        polygon_from += [number] * len(found)
    return Layout(loops, polygon_from, faces)


def _unchanged(made, arrays, separators):
    """(number of polygons,): all its triangles are there, at the vertices where they were."""
    source, count = made.origin.faces, len(arrays.triangles)
    own = np.flatnonzero(source >= 0)
    place = np.full(count, -1)
    place[source[own]] = own
    rows = np.arange(len(made.vertices))
    heaviest = made.origin.weights.argmax(axis=1)
    old = np.where(made.origin.weights[rows, heaviest] == 1,
                   made.origin.vertices[rows, heaviest], -1)
    good = np.bincount(source[own], minlength=count) == 1
    good &= (old[made.faces[place]] == arrays.triangles).all(axis=1)
    if separators:  # a curve along a diagonal parts a polygon
        n = len(made.vertices)
        cuts = np.array([a * n + b for a, b in separators])
        ends = np.sort(np.stack([made.faces, np.roll(made.faces, -1, axis=1)], -1), axis=-1)
        on_curve = np.isin(ends[..., 0] * n + ends[..., 1], cuts).any(axis=1)
        good &= ~on_curve[place]
    result = np.ones(arrays.polygon_count, bool)
    result[arrays.polygons[~good]] = False
    return result


def _whole_ones(made, arrays, whole):
    own = np.flatnonzero(made.origin.faces >= 0)
    corner = np.zeros(len(arrays.loop_vertices), np.int64)
    corner[arrays.loops[made.origin.faces[own]].ravel()] = \
        (3 * own[:, None] + np.arange(3)).ravel()
    chosen = np.flatnonzero(whole)
    return [corner[start:start + total] for start, total in
            zip(arrays.starts[chosen], arrays.totals[chosen])], chosen.tolist()


def _joined(faces, triangles, separators):
    """Corners of polygons around triangles that no curve parts; the triangles where there is none."""
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
        found += [loop] if loop else [[3 * t, 3 * t + 1, 3 * t + 2] for t in members]
    return found


def _around(rim):
    """The corners in their order; None if the rim has several loops."""
    at, loop = next(iter(rim)), []
    while len(loop) < len(rim):
        if at not in rim:
            return None
        at, corner = rim[at]
        if loop and corner == loop[0]:
            return None
        loop.append(corner)
    return loop
