"""Halves every edge of a PLY file by talweg-scenes: refine.py IN OUT TIMES. Old vertices stay."""
import struct
import sys


def read(path):
    with open(path, "rb") as file:
        counts = {}
        while (line := file.readline().split()) != [b"end_header"]:
            if line[0] == b"element":
                counts[line[1]] = int(line[2])
        points = [struct.unpack("<3f", file.read(12)) for _ in range(counts[b"vertex"])]
        triangles = [struct.unpack("<B3i", file.read(13))[1:] for _ in range(counts[b"face"])]
    return points, triangles


def halved(points, triangles):
    points, middles, result = list(points), {}, []

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            middles[key] = len(points)
            points.append(tuple((p + q) / 2 for p, q in zip(points[a], points[b])))
        return middles[key]

    for a, b, c in triangles:
        x, y, z = middle(a, b), middle(b, c), middle(c, a)
        result += [(a, x, z), (x, b, y), (z, y, c), (x, y, z)]
    return points, result


def write(path, points, triangles):
    with open(path, "wb") as file:
        file.write(
            b"ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\n"
            b"property float y\nproperty float z\nelement face %d\n"
            b"property list uchar int vertex_indices\nend_header\n" % (len(points), len(triangles))
        )
        for point in points:
            file.write(struct.pack("<3f", *point))
        for triangle in triangles:
            file.write(struct.pack("<B3i", 3, *triangle))


mesh = read(sys.argv[1])
for _ in range(int(sys.argv[3])):
    mesh = halved(*mesh)
write(sys.argv[2], *mesh)
