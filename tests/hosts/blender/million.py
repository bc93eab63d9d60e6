"""Times of the tool and of a curve object's values on a large mesh. This program is not a test: it prints a
table.

blender --background --factory-startup --python tests/hosts/blender/million.py -- ADDON.zip MESH.ply
"""

import sys
import time
from pathlib import Path

import bpy
import numpy as np

addon, mesh = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.preferences.addon_install(filepath=addon)
bpy.ops.preferences.addon_enable(module="talweg_blender")
sys.path.insert(0, str(Path(__file__).parent))

from talweg_blender import session  # noqa: E402
from talweg_blender.drawing_tool.drawn import Drawn  # noqa: E402
from talweg_blender.drawing_tool.view import View  # noqa: E402

import scene  # noqa: E402

_ROUNDS = 9


def told(what, function, rounds=_ROUNDS):
    """The best of some rounds: seconds of the clock, and of the processor in all threads."""
    clock, processor = [], []
    for number in range(rounds):
        begun = time.perf_counter(), time.process_time()
        function(number)
        clock.append(time.perf_counter() - begun[0])
        processor.append(time.process_time() - begun[1])
    print(f"TIME {what:58} {min(clock):7.3f} s, {min(processor):7.3f} s of the processor", flush=True)


def from_above(obj):
    """A view that fits the object, 1,000 pixels wide, and the object's middle."""
    corners = np.array([corner[:] for corner in obj.bound_box])
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = 2 / (high - low).max()
    matrix = np.diag([scale, scale, -scale / 4, 1])
    matrix[:3, 3] = -np.diag(matrix)[:3] * (low + high) / 2
    return View(matrix, 1000, 1000)


def stroke(work, view, places):
    work.press(view, places[0])
    for one, other in zip(places, places[1:]):
        for t in np.linspace(0, 1, 40)[1:]:
            work.move(view, np.array(one) * (1 - t) + np.array(other) * t)
    work.release(view, places[-1])


scene.empty()
bpy.ops.import_mesh.ply(filepath=mesh)
obj = bpy.context.object
view = from_above(obj)
print(f"TIME {len(obj.data.polygons)} faces")
begun = []
told("begin: read, open", lambda _: begun.append(Drawn(bpy.context, obj)), 1)
drawn = begun[0]
work = drawn.work
told("first stroke: pick points by Blender's tree, smooth", lambda _: (
    stroke(work, view, [(420, 480), (470, 520), (520, 500), (580, 540)]), drawn.wait()), 1)
if drawn.error or drawn.result is None:
    sys.exit(f"The stroke gives no curve: {drawn.error}")
print(f"TIME {len(work.editor.lines[0].points)} points drawn, {len(drawn.result.curve)} of the curve")
told("tau by the wheel, until it is seen", lambda k: (work.turn(1 if k % 2 else -1), drawn.wait()))


def waits(number):
    """The time that blocks the window: sending the request, and showing the answer. The thread works in
    between."""
    global waited  # pylint: disable=global-statement
    start = time.perf_counter()
    work.turn(1 if number % 2 else -1)
    asked = time.perf_counter()
    while drawn.live.is_busy:
        time.sleep(0.001)
    answered = time.perf_counter()
    drawn.poll()
    waited = min(waited, asked - start + time.perf_counter() - answered)


waited = 1e9
for number in range(_ROUNDS):
    waits(number)
print(f"TIME {'of it the window waits for':58} {waited:7.3f} s")
line = work.editor.lines[0]
middle = drawn.result.curve.positions[len(drawn.result.curve) // 2]
hold = view.project([middle])[0]
work.press(view, hold)
told("a step of dragging, until it is seen",
     lambda k: (work.move(view, hold + [6 + 2 * k, 6]), drawn.wait()))
work.release(view, hold + [6, 6])
drawn.wait()
told("Enter", lambda _: drawn.finish(bpy.context), 1)
curve = next(one for one in bpy.data.objects if one.type == "CURVE")


def value(number):
    curve.talweg.tau = 1 + 0.1 * number


told("first value in the sidebar", value, 1)
told("a value in the sidebar", value)

# In edit mode, where Blender's own undo step of the mesh takes seconds.
bpy.data.objects.remove(curve)
found = session.surface_of(bpy.context, obj, False).mesh().draw(
    [int(np.abs(scene.vertices_of(obj) - p).sum(axis=1).argmin()) for p in line.positions[[0, -1]]])
scene.select_edges(obj, [int(v) for v in found.vertices])
told("edit mode: Smooth Curve on Surface", lambda _: bpy.ops.talweg.smooth_edges(), 1)
curve = next(one for one in bpy.data.objects if one.type == "CURVE")
told("edit mode: first value in the sidebar", value, 1)
told("edit mode: a value in the sidebar", value)
