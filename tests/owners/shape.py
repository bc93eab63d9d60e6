"""The mesh that every program writes, and the drawing on it."""

import numpy as np

SIZE = 12.0  # largest extent, mm


def _bumpy(directions):
    """The distance of the surface from the origin in these directions. All axes of the surface differ."""
    x, y, z = directions.T
    return 4 + 0.7 * np.sin(2 * x + y) + 0.5 * np.cos(3 * y - z) * x + 0.6 * z * z * y


def _icosahedron():
    g = (1 + 5 ** 0.5) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
                (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
             (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    return np.array(vertices, float), np.array(faces)


def _quartered(vertices, faces):
    edges = np.sort(faces[:, [[1, 2], [2, 0], [0, 1]]].reshape(-1, 2), axis=1)
    edges, numbers = np.unique(edges, axis=0, return_inverse=True)
    a, b, c = faces.T
    x, y, z = (len(vertices) + numbers.reshape(-1, 3)).T
    parts = [(a, z, y), (b, x, z), (c, y, x), (x, y, z)]
    return (np.vstack([vertices, vertices[edges].mean(axis=1)]),
            np.concatenate([np.stack(part, 1) for part in parts]))


def mesh():
    """A bumpy sphere of 2,562 vertices, exact as 32-bit floats, and 5,120 faces, without symmetry about the
    origin or an axis."""
    vertices, faces = _icosahedron()
    for _ in range(4):
        vertices, faces = _quartered(vertices, faces)
    vertices /= np.linalg.norm(vertices, axis=1)[:, None]
    placed = vertices * _bumpy(vertices)[:, None] * (1.3, 1, 0.8) + (1.5, -0.7, 2.2)
    return placed.astype(np.float32).astype(np.float64), faces


def _stroke(angles, tilt):
    """Positions near the surface on a circle around a tilted axis."""
    wobble = 0.25 * np.sin(9 * angles) + 0.02 * np.sin(61 * angles)
    ring = np.stack([np.cos(angles), np.sin(angles), wobble], 1)
    turn = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
    ring = ring @ turn.T / np.linalg.norm(ring, axis=1)[:, None]
    return ring * _bumpy(ring)[:, None] * (1.3, 1, 0.8) + (1.5, -0.7, 2.2)


def drawing():
    """A closed and an open stroke, which do not meet, as pairs (positions, closed)."""
    turn = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    return [(_stroke(turn, 0.5), True), (_stroke(np.linspace(0.2, 2, 80), 1.9), False)]


def labels():
    """One of four labels for each vertex, by the sides of two tilted planes."""
    x, y, z = (mesh()[0] - (1.5, -0.7, 2.2)).T
    return (x + 0.3 * y > 0).astype(int) + 2 * (z - 0.4 * x > 0.3)


def write_drawing(path, curves):
    """Writes curves as OBJ: positions with 17 digits, one line for each curve."""
    with open(path, "w", encoding="ascii") as out:
        first = 1
        for positions, closed in curves:
            for p in positions.tolist():
                out.write("v %.17g %.17g %.17g\n" % tuple(p))
            ids = list(range(first, first + len(positions))) + ([first] if closed else [])
            out.write("l " + " ".join(map(str, ids)) + "\n")
            first += len(positions)
