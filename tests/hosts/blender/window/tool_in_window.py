"""The tool in Blender's window, by simulated events from the toolbar to an undo after Enter; and long work
that Esc ends."""

import os
import shutil
import sys
import threading
import time
import traceback
from pathlib import Path

import bpy

try:
    import numpy as np
except ImportError:
    print("SKIPPED: Blender's Python has no numpy (Debian: python3-numpy)", flush=True)
    os._exit(0)

FOLDER = Path(__file__).parent.parent
sys.path[:0] = [str(FOLDER.parent / "python"), str(FOLDER)]


def hill(x, y):
    return 3 * np.sin(x / 7) * np.cos(y / 5)


def curves():
    return [one for one in bpy.data.objects if one.type == "CURVE"]


class Hand:
    """Moves and presses the mouse at places of the hills, which are seen from above."""

    def __init__(self, window, area, region):
        self.window, self.area, self.region = window, area, region

    def pixel(self, x, y):
        matrix = np.array(self.area.spaces.active.region_3d.perspective_matrix)
        clip = matrix @ np.array([x, y, hill(x, y), 1])
        return [int(round((value / clip[3] + 1) / 2 * size + start)) for value, size, start in zip(
            clip[:2], (self.region.width, self.region.height), (self.region.x, self.region.y))]

    def do(self, kind, value, place, **more):
        x, y = self.pixel(*place)
        self.window.event_simulate(type=kind, value=value, x=x, y=y, **more)

    def key(self, kind, place, **more):
        self.do(kind, "PRESS", place, **more)
        self.do(kind, "RELEASE", place, **more)

    def click(self, place):
        self.do("MOUSEMOVE", "NOTHING", place)
        yield
        self.do("LEFTMOUSE", "PRESS", place)
        yield
        self.do("LEFTMOUSE", "RELEASE", place)
        yield

    def drag(self, one, other):
        self.do("MOUSEMOVE", "NOTHING", one)
        yield
        self.do("LEFTMOUSE", "PRESS", one)
        yield
        for t in np.linspace(0, 1, 15)[1:]:
            self.do("MOUSEMOVE", "NOTHING", np.array(one) * (1 - t) + np.array(other) * t)
            yield
        self.do("LEFTMOUSE", "RELEASE", other)
        yield


def until(condition, what):
    """Waits up to two minutes, since the machine may be busy."""
    begin = time.monotonic()
    while time.monotonic() - begin < 120:
        if condition():
            return
        yield
    raise AssertionError(f"Waited in vain until {what}.")


def passes(place):
    """Whether the curve passes close to a place of the hills."""
    if not curves() or not curves()[0].data.splines:
        return False
    import scene

    points = scene.spline_points(curves()[0])
    return np.linalg.norm(points - [*place, hill(*place)], axis=1).min() < 0.2  # pixels are 0.1 units wide


def steps():
    """The actions of the test; each yield lets Blender run."""
    import scene
    import support

    scene.empty()
    name = scene.add_mesh(*support.hills()).name  # undo replaces objects
    window = bpy.context.window_manager.windows[0]
    area = next(one for one in window.screen.areas if one.type == "VIEW_3D")
    region = next(one for one in area.regions if one.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.view3d.view_axis(type="TOP")
        bpy.ops.view3d.view_selected()
        bpy.ops.wm.tool_set_by_id(name="talweg.draw_tool")
    bpy.ops.ed.undo_push(message="Begin")
    hand = Hand(window, area, region)
    preferences = bpy.context.preferences.view
    preferences.smooth_view = 0
    for _ in range(10):
        yield

    from talweg_blender.drawing_tool import tool

    for place in ((15, 15), (30, 20), (45, 40)):
        yield from hand.click(place)
    assert tool.is_at_work(), "the tool has begun"
    yield from until(lambda: all(map(passes, ((15, 15), (30, 20), (45, 40)))), "way-points are passed")
    yield from hand.drag((30, 20), (32, 28))
    yield from until(lambda: passes((32, 28)) and not passes((30, 20)), "the point is moved")
    for _ in range(2):
        hand.do("WHEELUPMOUSE", "PRESS", (40, 20), ctrl=True)
        yield
    yield from until(lambda: abs(curves()[0].talweg.tau - 1.5625) < 1e-5, "the wheel has turned tau")
    hand.key("Z", (40, 20), ctrl=True)
    yield from until(lambda: abs(curves()[0].talweg.tau - 1.25) < 1e-5, "a step is taken back")
    hand.key("RET", (40, 20))
    yield from until(lambda: not tool.is_at_work(), "Enter ends it")
    assert passes((32, 28)) and len(curves()) == 1 and curves()[0].parent.name == name
    hand.key("Z", (40, 20), ctrl=True)
    yield from until(lambda: not curves(), "Blender's undo removes the curve")
    hand.key("Z", (40, 20), ctrl=True, shift=True)
    yield from until(lambda: len(curves()) == 1, "and brings it back")

    bpy.context.view_layer.objects.active = curves()[0]  # the same tool edits it
    before = scene.spline_points(curves()[0])
    yield from hand.drag((32, 28), (30, 35))
    yield from until(lambda: passes((30, 35)), "the point is moved again")
    hand.key("ESC", (40, 20))
    yield from until(lambda: not tool.is_at_work(), "Esc ends it")
    np.testing.assert_array_equal(scene.spline_points(curves()[0]), before)

    bpy.context.view_layer.objects.active = bpy.data.objects[name]
    yield from hand.drag((10, 45), (30, 50))
    yield from until(lambda: len(curves()) == 2, "a stroke begins another curve")
    hand.key("ESC", (40, 20))
    yield from until(lambda: len(curves()) == 1, "Esc drops it")

    bpy.ops.mesh.primitive_cube_add(size=6, location=(-12, 20, 0))
    cube = bpy.context.object.name
    bpy.context.view_layer.objects.active = bpy.data.objects[name]
    yield
    for _ in range(2):  # the first click selects the object
        yield from hand.click((-12, 20))
    yield from until(tool.is_at_work, "a click on another mesh begins there")
    assert tool._now[0]._drawn.object_name == cube == bpy.context.object.name, bpy.context.object.name
    hand.key("ESC", (40, 20))
    yield from until(lambda: not tool.is_at_work(), "Esc ends it again")
    yield from all_beside_steps(window, area, region)
    yield from border_steps(window, area, region)


def specks(segments, rings):
    """A ball with two materials, random for each face."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=segments, ring_count=rings, radius=5)
    mesh = bpy.context.object.data
    for name in ("one", "other"):
        mesh.materials.append(bpy.data.materials.new(name))
    chance = np.random.default_rng(1)
    mesh.polygons.foreach_set("material_index", chance.integers(0, 2, len(mesh.polygons)))
    mesh.update()
    return bpy.context.object.name


def at_work():
    """Living threads of the add-on."""
    return [one for one in threading.enumerate() if one.name == "talweg"]


class Held:
    """Makes calls of a function of talweg.Mesh wait until they are released, or stopped, or for a minute."""

    def __init__(self, name):
        from talweg_blender.package import talweg

        self.mesh, self.name, self.is_free = talweg.Mesh, name, False
        self.whole = getattr(talweg.Mesh, name)

        def held(mesh, *of, progress=None, **how):
            began = time.monotonic()
            while not self.is_free and time.monotonic() - began < 60:
                time.sleep(0.01)
                if progress is not None and progress("held", 0.5) is False:
                    raise talweg.Cancelled("Cancelled.")
            return self.whole(mesh, *of, progress=progress, **how)

        setattr(talweg.Mesh, name, held)

    def restore(self):
        setattr(self.mesh, self.name, self.whole)


def ball():
    """Makes a ball with a selected curve around it; returns the ball's name."""
    import scene

    scene.empty()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=24, radius=5)
    obj = bpy.context.object
    obj.data.uv_layers.new(name="Survives")
    turn = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    curve = bpy.data.curves.new("Round", "CURVE")
    curve.dimensions = "3D"
    spline = curve.splines.new("POLY")
    spline.points.add(len(turn) - 1)
    spline.use_cyclic_u = True
    spline.points.foreach_set("co", np.stack([5 * np.cos(turn), 5 * np.sin(turn), 0.3 + 0 * turn,
                                              1 + 0 * turn], -1).astype(np.float32).ravel())
    along = bpy.data.objects.new("Round", curve)
    bpy.context.scene.collection.objects.link(along)
    along.select_set(True)
    return obj.name


def counts():
    """(objects, vertices, faces) of all meshes."""
    found = [one.data for one in bpy.data.objects if one.type == "MESH"]
    return len(found), sum(len(one.vertices) for one in found), sum(len(one.polygons) for one in found)


def all_beside_steps(window, area, region):
    """Operators on meshes: Blender stays usable, Esc ends them, and their changes can be undone."""
    import scene

    hand = Hand(window, area, region)

    def begin(name):
        with bpy.context.temp_override(window=window, area=area, region=region):
            bpy.ops.ed.undo_push(message="Begin")
            return getattr(bpy.ops.talweg, name)("INVOKE_DEFAULT")

    def turned(name):
        """Inverts a face, in edit mode, where such a mesh is refused."""
        obj = bpy.data.objects[name]
        obj.data.polygons[40].flip()
        obj.data.update()
        bpy.ops.object.mode_set(mode="EDIT")

    for name, function, mode in (("cut", "cut", "OBJECT"), ("separate", "cut", "OBJECT"),
                                 ("repair", "repair", "EDIT")):
        obj = ball()
        if name == "repair":
            turned(obj)
        held, before = Held(function), counts()
        assert begin(name) == {"RUNNING_MODAL"}, name
        for _ in range(10):
            yield
        assert at_work() and counts() == before, name
        hand.key("ESC", (30, 30))
        yield from until(lambda: not at_work(), f"Esc ends {name}")
        for _ in range(5):
            yield
        assert counts() == before and bpy.context.object.mode == mode, name

        assert begin(name) == {"RUNNING_MODAL"}, name
        held.is_free = True
        yield from until(lambda: not at_work(), f"{name} has worked")
        for _ in range(5):
            yield
        assert bpy.context.object.mode == mode and "Survives" in bpy.data.objects[obj].data.uv_layers, name
        if name == "repair":
            bpy.ops.object.mode_set(mode="OBJECT")
            assert not is_turned(bpy.data.objects[obj].data)
            hand.key("Z", (30, 30), ctrl=True)  # undoes the change of mode
            yield
        else:
            assert counts()[1] > before[1], name
        hand.key("Z", (30, 30), ctrl=True)
        for _ in range(5):
            yield
        assert counts() == before, f"undo takes {name} back"
        if name == "repair":
            bpy.ops.object.mode_set(mode="OBJECT")
            assert is_turned(bpy.data.objects[obj].data), "undo takes the repair back"

        held.is_free = False  # a script changes the mesh meanwhile
        bpy.ops.object.mode_set(mode="OBJECT")
        assert begin(name) == {"RUNNING_MODAL"}, name
        yield
        bpy.data.objects[obj].data.vertices[0].co.z += 1
        bpy.data.objects[obj].data.update()
        yield
        held.is_free = True
        yield from until(lambda: not at_work(), f"{name} has worked again")
        for _ in range(5):
            yield
        assert counts() == before, f"{name} leaves what was changed"
        hand.key("ESC", (30, 30))  # closes the error's menu at the mouse pointer
        yield
        held.restore()
    scene.empty()


def is_turned(mesh):
    """Whether an oriented edge occurs twice."""
    passed = [(a, b) for polygon in mesh.polygons for a, b in
              zip(polygon.vertices, [*polygon.vertices[1:], polygon.vertices[0]])]
    return len(set(passed)) < len(passed)


def border_steps(window, area, region):
    """Smooth Material Borders: Blender stays usable, Esc ends it, and its change can be undone."""
    import scene

    hand = Hand(window, area, region)

    def count(name):
        return len(bpy.data.objects[name].data.polygons)

    def begin():
        with bpy.context.temp_override(window=window, area=area, region=region):
            bpy.ops.ed.undo_push(message="Begin")
            return bpy.ops.talweg.material_borders("INVOKE_DEFAULT")

    scene.empty()
    long, held = specks(32, 24), Held("labels")
    before = count(long)
    assert begin() == {"RUNNING_MODAL"}
    for _ in range(10):
        yield
    assert at_work() and count(long) == before
    hand.key("ESC", (0, 0))
    yield from until(lambda: not at_work(), "Esc ends the work")
    for _ in range(10):
        yield
    assert count(long) == before
    held.restore()

    scene.empty()
    short = specks(32, 24)
    before = count(short)
    begin()
    yield from until(lambda: count(short) > before, "borders are edges")
    yield
    hand.key("Z", (0, 0), ctrl=True)
    yield from until(lambda: count(short) == before, "undo takes them back")


def run(work):
    """Runs a step on each call; ends the program after the last."""
    try:
        next(work)
        return 0.05
    except StopIteration:
        print("The tool works in its window.", flush=True)
        os._exit(0)
    except BaseException:  # the timer must not continue after a failure
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)


shutil.rmtree(os.environ["BLENDER_USER_RESOURCES"], ignore_errors=True)
os.makedirs(os.environ["BLENDER_USER_RESOURCES"])
bpy.context.preferences.view.show_splash = False
bpy.ops.preferences.addon_install(filepath=sys.argv[sys.argv.index("--") + 1])
bpy.ops.preferences.addon_enable(module="talweg_blender")
bpy.app.timers.register(lambda work=steps(): run(work), first_interval=1)
