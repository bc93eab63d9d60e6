"""Drawings of the user: selected edges, or curve objects."""

import hashlib
from typing import List, NamedTuple

import numpy as np

from .package import talweg


class Drawing(NamedTuple):
    curves: List[talweg.Curve]
    key: str  # equal for the same drawing
    names: List[str] = []  # the user's name of each curve; empty: the curves have none
    warnings: List[str] = []


def key_of(kind, *arrays):
    found = hashlib.sha1()
    for array in arrays:
        found.update(str(array.shape).encode() + np.ascontiguousarray(array).tobytes())
    return f"{kind} {found.hexdigest()}"


class MeshArrays:
    """A Blender mesh as arrays: vertices (n, 3) float32 in the object's space; triangles (m, 3); for each
    triangle its polygon and its corners (loops); and the polygons."""

    def __init__(self, mesh):
        mesh.calc_loop_triangles()
        self.vertices = np.empty((len(mesh.vertices), 3), np.float32)
        mesh.vertices.foreach_get("co", self.vertices.ravel())
        self.triangles = np.empty((len(mesh.loop_triangles), 3), np.int32)
        mesh.loop_triangles.foreach_get("vertices", self.triangles.ravel())
        self.polygons = np.empty(len(mesh.loop_triangles), np.int32)
        mesh.loop_triangles.foreach_get("polygon_index", self.polygons)
        self.loops = np.empty((len(mesh.loop_triangles), 3), np.int32)
        mesh.loop_triangles.foreach_get("loops", self.loops.ravel())
        self.loop_vertices = np.empty(len(mesh.loops), np.int32)
        mesh.loops.foreach_get("vertex_index", self.loop_vertices)
        self.starts = np.empty(len(mesh.polygons), np.int32)
        mesh.polygons.foreach_get("loop_start", self.starts)
        self.totals = np.empty(len(mesh.polygons), np.int32)
        mesh.polygons.foreach_get("loop_total", self.totals)

    @property
    def polygon_count(self):
        return len(self.starts)


def selected_edges(mesh):
    """The Drawing of the selected edges: first curves between ends and junctions, then loops. Edges without
    faces are left out, with a warning.

    :raises talweg.BadCurve: if no edge with a face is selected.
    """
    chosen = np.empty(len(mesh.edges), bool)
    mesh.edges.foreach_get("select", chosen)
    ends = np.empty((len(mesh.edges), 2), np.int32)
    mesh.edges.foreach_get("vertices", ends.ravel())
    if not chosen.any():
        raise talweg.BadCurve("No edges are selected.")
    has_face = _with_faces(mesh)
    wire = ends[chosen & ~has_face]
    chosen &= has_face
    message = f"{len(wire)} of the selected edges are wire, without a face" if len(wire) != 1 else \
        "One of the selected edges is wire, without a face"
    where = f" (first: between vertices {wire[0, 0]} and {wire[0, 1]})" if len(wire) else ""
    if not chosen.any():
        raise talweg.BadCurve(f"{message}{where}; a curve needs a surface to lie on.")
    curves = [talweg.Curve(vertices=chain, closed=closed) for chain, closed in chains(ends[chosen])]
    return Drawing(curves, key_of("edges", np.unique(np.sort(ends[chosen], axis=1), axis=0)),
                   warnings=[f"{message}{where}: left out."] if len(wire) else [])


def _with_faces(mesh):
    """Whether each edge has a face, (number of edges,)."""
    of_loops = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("edge_index", of_loops)
    found = np.zeros(len(mesh.edges), bool)
    found[of_loops] = True
    return found


def chains(edges):
    """Joins edges, pairs of vertices, into chains (list of vertices, closed): first the open ones between
    ends and junctions, then loops. Chains are ordered by the lowest vertex at their beginning."""
    around = {}
    for a, b in edges.tolist():
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)
    for neighbours in around.values():
        neighbours.sort()
    left = {(a, b) for a in around for b in around[a]}
    found = []

    def walk(start, second):
        chain = [start, second]
        left.difference_update([(start, second), (second, start)])
        while len(around[chain[-1]]) == 2 and chain[-1] != start:
            step = [v for v in around[chain[-1]] if (chain[-1], v) in left]
            if not step:
                break
            left.difference_update([(chain[-1], step[0]), (step[0], chain[-1])])
            chain.append(step[0])
        closed = chain[-1] == start
        found.append((chain[:-1] if closed else chain, closed))

    for wanted in (False, True):  # first from ends and junctions; the remaining edges form loops
        for start in sorted(around):
            for second in around[start]:
                if (start, second) in left and (wanted or len(around[start]) != 2):
                    walk(start, second)
    return found


def curve_objects(context, obj, surface, known):
    """The Drawing of the splines of all selected curve objects, in the object's space. A spline that shows a
    curve of ``known`` is replaced by that curve, which has double precision.

    :raises talweg.BadCurve: if no curve object is selected, or one has no points.
    """
    chosen = [o for o in context.selected_objects if o.type == "CURVE"]
    if not chosen:
        raise talweg.BadCurve("No curve object is selected; select one, then the mesh (Shift-click).")
    to_object = np.array(obj.matrix_world.inverted_safe())
    curves, names, warnings = [], [], []
    for one in chosen:
        move = to_object @ np.array(one.matrix_world)
        for number, spline in enumerate(one.data.splines):
            curves.append(_exact(_spline(spline, move, one.name), known))
            names.append(one.name + (f", spline {number}" if len(one.data.splines) > 1 else ""))
            warnings += _far(curves[-1], names[-1], surface)
    if not curves:
        raise talweg.BadCurve("The selected curve objects have no splines.")
    return Drawing(curves, "", names, warnings)


def _far(curve, name, surface):
    """A warning if the curve lies far from the surface; else an empty list."""
    if curve.faces is not None or not np.isfinite(curve.positions).all():
        return []
    distance = surface.farthest(curve.positions)
    return [f"{name} lies {surface.distance_text(distance)}."] if distance > surface.far else []


def _spline(spline, move, name):
    points = spline.bezier_points if spline.type == "BEZIER" else spline.points
    if spline.type == "NURBS":
        raise talweg.BadCurve(f"{name} is a NURBS curve; convert it to a polygon first (Set Spline "
                              "Type > Poly).")
    values = np.array([tuple(point.co)[:3] for point in points], float).reshape(-1, 3)
    return talweg.Curve(positions=values @ move[:3, :3].T + move[:3, 3], closed=spline.use_cyclic_u)


def _exact(curve, known):
    """The known curve that is equal to this one up to rounding, or None."""
    for one in known:
        if one.closed == curve.closed and len(one) == len(curve) and \
                np.allclose(one.positions, curve.positions, rtol=1e-6,
                            atol=1e-6 * np.abs(one.positions).max()):
            return one
    return curve
