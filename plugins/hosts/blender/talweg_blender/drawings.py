"""What the user has drawn: selected edges, or strokes of the annotation tool."""

import numpy as np

from .package import talweg


class MeshArrays:
    """A Blender mesh as arrays: vertices (n, 3) float32 in the object's own space, triangles (m, 3),
    the polygon of each triangle and the corners (loops) of it, and the polygons themselves."""

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
    """The selected edges as curves: as long as they can be, to ends and junctions, then loops.

    :raises talweg.BadCurve: if there are none, or one has no face.
    """
    chosen = np.empty(len(mesh.edges), bool)
    mesh.edges.foreach_get("select", chosen)
    ends = np.empty((len(mesh.edges), 2), np.int32)
    mesh.edges.foreach_get("vertices", ends.ravel())
    if not chosen.any():
        raise talweg.BadCurve("No edges are selected.")
    return [talweg.Curve(vertices=chain, closed=closed) for chain, closed in chains(ends[chosen])]


def chains(edges):
    """Pairs of vertices as (list of vertices, closed): open from end or junction to end or
    junction, then closed loops; in the order of the lowest vertex that each begins with."""
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

    for wanted in (False, True):  # first from ends and junctions, then what is left: loops
        for start in sorted(around):
            for second in around[start]:
                if (start, second) in left and (wanted or len(around[start]) != 2):
                    walk(start, second)
    return found


def mean_edge(arrays):
    """Over all corners of all triangles, in the object's own units; 0 without triangles."""
    corners = arrays.vertices[arrays.triangles].astype(float)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return float(sides.mean()) if sides.size else 0.0


def thinned(points, distance):
    """Without the points nearer than this to the one kept before; first and last stay.

    A hand that rests draws hooks smaller than a triangle, and a curve must not touch itself."""
    kept = [0]
    for k in range(1, len(points)):
        if not np.linalg.norm(points[k] - points[kept[-1]]) < distance:  # also where it is no number
            kept.append(k)
    if len(kept) > 1 and kept[-1] != len(points) - 1:
        kept[-1] = len(points) - 1
    return points[kept]


def annotation_strokes(context, obj, closed, spacing):
    """The strokes of the scene's active annotation layer as curves in the object's own space,
    their points at least `spacing` apart.

    :raises talweg.BadCurve: if there are none on the surface.
    """
    data = context.scene.grease_pencil
    layer = data.layers.active if data and len(data.layers) else None
    frames = layer.frames if layer else ()
    shown = [f for f in frames if f.frame_number <= context.scene.frame_current]
    frame = max(shown, key=lambda f: f.frame_number, default=None)
    if frame is None or not len(frame.strokes):
        raise talweg.BadCurve("There are no annotations; draw with the annotation tool first.")
    to_object = np.array(obj.matrix_world.inverted_safe())
    curves = []
    for number, stroke in enumerate(frame.strokes):
        if stroke.display_mode != "3DSPACE":
            raise talweg.BadCurve(f"Stroke {number} of the annotation is not on a surface; set the "
                                  "tool's Placement to Surface before drawing.")
        points = np.empty((len(stroke.points), 3), np.float32)
        stroke.points.foreach_get("co", points.ravel())
        in_object = points @ to_object[:3, :3].T + to_object[:3, 3]
        curves.append(talweg.Curve(positions=thinned(in_object, spacing),
                                   closed=closed or stroke.use_cyclic))
    return curves


def curve_objects(context, obj, known):
    """The splines of all selected curve objects as curves in the object's own space; those that show
    a known curve on the mesh are exactly that one.

    :raises talweg.BadCurve: if no curve object is selected, or one has no points.
    """
    chosen = [o for o in context.selected_objects if o.type == "CURVE"]
    if not chosen:
        raise talweg.BadCurve("No curve object is selected; select one, then the mesh (Shift-click).")
    to_object = np.array(obj.matrix_world.inverted_safe())
    curves = []
    for one in chosen:
        move = to_object @ np.array(one.matrix_world)
        for spline in one.data.splines:
            curves.append(_exact(_spline(spline, move, one.name), known))
    if not curves:
        raise talweg.BadCurve("The selected curve objects have no splines.")
    return curves


def _spline(spline, move, name):
    points = spline.bezier_points if spline.type == "BEZIER" else spline.points
    if spline.type == "NURBS":
        raise talweg.BadCurve(f"{name} is a NURBS curve; convert it to a polygon first (Set Spline "
                              "Type > Poly).")
    values = np.array([tuple(point.co)[:3] for point in points], float).reshape(-1, 3)
    return talweg.Curve(positions=values @ move[:3, :3].T + move[:3, 3], closed=spline.use_cyclic_u)


def _exact(curve, known):
    """The known curve that was rounded to this one, if there is one."""
    for one in known:
        if one.closed == curve.closed and len(one) == len(curve) and \
                np.allclose(one.positions, curve.positions, rtol=1e-6,
                            atol=1e-6 * np.abs(one.positions).max()):
            return one
    return curve
