"""Results cut into the mesh: its faces are split along the curve, whose edges end up selected."""

import bmesh

from .package import talweg


def _edge_point(bm, corners, weights):
    """(edge, its vertex with the lower index, part of the way from there) where a point lies on an
    edge of the mesh; None where it is inside a polygon, be it on a diagonal of it."""
    on = [k for k in range(3) if weights[k] > 0]
    if len(on) != 2:
        return None
    a, b = sorted((int(corners[k]), weights[k]) for k in on)
    edge = bm.edges.get((bm.verts[a[0]], bm.verts[b[0]]))
    return None if edge is None else (edge, a[0], b[1])


class _Cut:
    def __init__(self, bm, arrays, curves):
        self.bm = bm
        self.arrays = arrays
        # Pieces of a cut polygon carry its number plus 1. (A new layer makes older references
        # invalid.)
        self.layer = bm.faces.layers.int.new("talweg_polygon")
        for group in (bm.verts, bm.faces):
            group.index_update()
            group.ensure_lookup_table()
        for curve in curves:
            for polygon in arrays.polygons[curve.faces].tolist():
                bm.faces[polygon][self.layer] = polygon + 1
        self.original = list(bm.verts)
        self.cut_edges = []

    def locate(self, curve):
        """For each point a vertex of the mesh, or (edge's vertices, part), or None: inside."""
        places = []
        for vertex, face, weights in zip(curve.vertices, curve.faces, curve.barycentrics):
            if vertex >= 0:
                places.append(int(vertex))
                continue
            found = _edge_point(self.bm, self.arrays.triangles[face], weights)
            places.append(None if found is None else
                          (found[1], found[0].other_vert(self.bm.verts[found[1]]).index, found[2]))
        return places

    def split_edges(self, curves, places):
        """Vertices for all points on edges: {place: vertex}."""
        wanted = {}
        for curve, where in zip(curves, places):
            for place, position in zip(where, curve.positions):
                if isinstance(place, tuple):
                    wanted.setdefault(place[:2], {})[place[2]] = position
        made = {}
        for (a, b), parts in wanted.items():
            start, rest, whole = self.original[a], self.original[b], 1.0
            for part in sorted(parts, reverse=True):
                edge = self.bm.edges.get((start, rest))
                _, rest = bmesh.utils.edge_split(edge, start, min(part / whole, 1.0))
                rest.co = parts[part]
                made[a, b, part] = rest
                whole = part
        return made

    def connect(self, polygon, a, b, between):
        """Splits the piece of the polygon with both vertices along points between them."""
        edge = self.bm.edges.get((a, b))
        if edge is not None and not between:
            self.cut_edges.append(edge)
            return
        for face in a.link_faces:
            if face[self.layer] == polygon + 1 and b in face.verts:
                break
        else:
            raise talweg.Unsupported("The curve passes a polygon of the mesh more than once in a "
                                     "way that cannot be cut; triangulate the mesh first (Ctrl T).")
        before = set(face.verts)
        made, _ = bmesh.utils.face_split(face, a, b, coords=[tuple(p) for p in between])
        path = (set(made.verts) - before) | {a, b}
        self.cut_edges += [e for e in made.edges if set(e.verts) <= path
                           and (between == [] or not set(e.verts) <= before)]

    def along(self, curve, vertices):
        """Cuts along one curve; returns how many of its segments end inside a polygon."""
        at = [k for k, vertex in enumerate(vertices) if vertex is not None]
        if not at:
            raise talweg.Unsupported("A curve inside one polygon cannot be cut into the mesh.")
        n = len(vertices)
        stops = at + [at[0] + n] if curve.closed else at
        for first, last in zip(stops[:-1], stops[1:]):
            between = [curve.positions[k % n] for k in range(first + 1, last)]
            polygon = int(self.arrays.polygons[curve.faces[first % n]])
            self.connect(polygon, vertices[first % n], vertices[last % n], between)
        return 0 if curve.closed else at[0] + n - 1 - at[-1]


def cut(bm, arrays, curves):
    """Cuts smoothed curves into a BMesh of the mesh that they lie on.

    Returns the edges along the curves, and the number of segments that were left out because an
    open curve ends inside a face.

    :raises talweg.Unsupported: what it did to `bm` until then stays, so try a copy first.
    """
    job = _Cut(bm, arrays, curves)
    places = [job.locate(curve) for curve in curves]
    made = job.split_edges(curves, places)
    left_out = 0
    for curve, where in zip(curves, places):
        vertices = [None if place is None else
                    job.original[place] if isinstance(place, int) else made[place]
                    for place in where]
        left_out += job.along(curve, vertices)
    bm.faces.layers.int.remove(job.layer)
    return job.cut_edges, left_out


def select(bm, edges):
    """Selects these edges and nothing else."""
    for group in (bm.faces, bm.edges, bm.verts):
        for element in group:
            if element.select:
                element.select = False
    for edge in edges:
        edge.select_set(True)
