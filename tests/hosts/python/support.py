"""Meshes, drawings, and the driver for comparisons."""

import json
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

SOURCE = Path(os.environ["TALWEG_SOURCE"])
MESHES = Path(os.environ.get("TALWEG_MESHES") or SOURCE / "../shared/meshes")
CURVES = MESHES / "../reference/curves"


def hills(n=60):
    """A square of n x n vertices with hills; vertex (row, column) is row * n + column."""
    i, k = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    z = 3 * np.sin(i / 7) * np.cos(k / 5)
    a = (i * n + k)[:-1, :-1].ravel()
    faces = np.concatenate([np.stack([a, a + n, a + n + 1], -1),
                            np.stack([a, a + n + 1, a + 1], -1)])
    return np.stack([i, k, z], -1).reshape(-1, 3).astype(float), faces


def torus(n=60):
    """A torus of n x n vertices, around the z axis, without boundary."""
    i, k = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    u, v = 2 * np.pi * i / n, 2 * np.pi * k / n
    r = 3 + np.cos(v)
    vertices = np.stack([r * np.cos(u), r * np.sin(u), np.sin(v)], -1).reshape(-1, 3)
    a, b = i * n + k, (i + 1) % n * n + k
    c, d = (i + 1) % n * n + (k + 1) % n, i * n + (k + 1) % n
    faces = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3),
                            np.stack([a, c, d], -1).reshape(-1, 3)])
    return vertices, faces


def staircase(n=60):
    """A jagged drawing on hills(): neighbours along edges."""
    path = []
    for k in range(5, n - 5):
        path += [k * n + k, k * n + k + 1] if k % 4 else [k * n + k, (k + 1) * n + k]
    return np.array(path + [(n - 5) * n + n - 5])


def ring(n=60, column=10):
    """A jagged loop on torus(), the long way around, closed by its last edge."""
    path = []
    for i in range(0, n, 2):
        path += [i * n + column, (i + 1) * n + column + 1, (i + 2) % n * n + column + 1]
    return np.array(path)


def write_obj(path, vertices, faces):
    with open(path, "w", encoding="ascii") as out:
        for v in np.asarray(vertices, dtype=float).tolist():
            out.write("v %r %r %r\n" % tuple(v))
        for f in (np.asarray(faces, dtype=int) + 1).tolist():
            out.write("f %d %d %d\n" % tuple(f))


def read_ply(path):
    """Vertices (float32 or float64, as stored) and triangles of a binary PLY file."""
    data = Path(path).read_bytes()
    head, body = data.split(b"end_header\n", 1)
    kinds = {"float": "<f4", "double": "<f8", "int": "<i4", "uint": "<u4", "uchar": "u1"}
    counts, fields = {}, []
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            counts[words[1]] = int(words[2])
        elif words[0] == "property" and words[1] != "list" and "face" not in counts:
            fields.append((words[2], kinds[words[1]]))
    vertices = np.frombuffer(body, np.dtype(fields), counts["vertex"])
    faces = np.frombuffer(body, np.dtype([("n", "u1"), ("v", "<i4", 3)]), counts["face"],
                          vertices.nbytes)
    return np.stack([vertices[x] for x in "xyz"], -1), faces["v"]


def real_mesh(name):
    """The path of a real mesh; skips the test if it is missing."""
    path = MESHES / name
    if not path.is_file():
        raise unittest.SkipTest(f"no {name} in {MESHES} (TALWEG_MESHES)")
    return path


def driver(folder, *arguments):
    """Runs the driver in a folder; a failure becomes an AssertionError with its messages."""
    done = subprocess.run([os.environ["TALWEG_DRIVER"], "--quiet", *map(str, arguments)],
                          cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        raise AssertionError(done.stderr)


def driver_curves(path):
    """Curves of the driver's JSON: closed, faces, barycentrics, positions."""
    curves = []
    for curve in json.loads(Path(path).read_text())["curves"]:
        points = curve["points"]
        curves.append((curve["closed"], np.array([p["face"] for p in points]),
                       np.array([p["barycentric"] for p in points]),
                       np.array([p["xyz"] for p in points])))
    return curves
