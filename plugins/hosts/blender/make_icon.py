"""Makes the tool's icon, talweg_blender/drawing_tool/talweg.draw.dat: the triangles that Blender draws.

python3 make_icon.py FILE
"""

import math
import sys

#: Corners of the jagged drawing. The icon is a square 255 wide with its origin at the lower left.
JAGGED = [(28, 60), (60, 128), (84, 86), (116, 160), (140, 116), (176, 190), (196, 150), (228, 206)]
GREY, ROSE, WHITE = (150, 150, 150, 255), (255, 92, 150, 255), (255, 255, 255, 255)


def smooth(count=28):
    """Points of the smooth curve, a flat S from the first point of the drawing to the last."""
    found = []
    for k in range(count + 1):
        t = k / count
        found.append((28 + 200 * t, 60 + 146 * t + 16 * math.sin(2 * math.pi * t)))
    return found


def thick(path, width):
    """Triangles of a strip of this width along a polyline."""
    sides = []
    for k, (x, y) in enumerate(path):
        before, after = path[max(k - 1, 0)], path[min(k + 1, len(path) - 1)]
        dx, dy = after[0] - before[0], after[1] - before[1]
        off = width / 2 / math.hypot(dx, dy)
        sides.append(((x - dy * off, y + dx * off), (x + dy * off, y - dx * off)))
    for (a, b), (c, d) in zip(sides, sides[1:]):
        yield a, b, d
        yield a, d, c


def disc(center, radius, count=12):
    rim = [(center[0] + radius * math.cos(2 * math.pi * k / count),
            center[1] + radius * math.sin(2 * math.pi * k / count)) for k in range(count + 1)]
    for a, b in zip(rim, rim[1:]):
        yield center, a, b


def icon():
    """The bytes of the icon: a header, the corners of all triangles, and their colours."""
    corners, colours = bytearray(), bytearray()
    for triangles, colour in ((thick(JAGGED, 11), GREY), (thick(smooth(), 20), ROSE),
                              (disc(JAGGED[0], 21), WHITE), (disc(JAGGED[-1], 21), WHITE)):
        for triangle in triangles:
            corners += bytes(min(max(round(value), 0), 255) for point in triangle for value in point)
            colours += bytes(colour * 3)
    return b"VCO\0" + bytes((255, 255, 0, 0)) + corners + colours


if __name__ == "__main__":
    with open(sys.argv[1], "wb") as out:
        out.write(icon())
