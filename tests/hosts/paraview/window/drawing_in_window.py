"""The widget that draws on the mesh in ParaView's window, by events of its view from clicks to an abort.

xvfb-run -a paraview --dr --script=drawing_in_window.py
"""

import math
import os
import sys
import traceback

from paraview import simple as pv
from vtkmodules.vtkCommonCore import reference

try:
    pv.LoadPlugin(os.environ["TALWEG_PARAVIEW"], remote=False, ns=vars(pv))
except Exception:  # otherwise the window would wait for a user
    traceback.print_exc()
    sys.stderr.flush()
    os._exit(1)


class Hand:
    """Moves and presses the mouse in a view at places in space."""

    def __init__(self, view):
        self.view = view
        self.interactor = view.GetInteractor()

    def pixel(self, place):
        renderer = self.view.GetRenderer()
        renderer.SetWorldPoint(*place, 1)
        renderer.WorldToDisplay()
        return [round(x) for x in renderer.GetDisplayPoint()[:2]]

    def do(self, event, pixel, key=""):
        self.interactor.SetEventInformation(*pixel, 0, 0, "\0", 0, key)
        self.interactor.InvokeEvent(event)

    def click(self, place):
        pixel = self.pixel(place)
        self.do("MouseMoveEvent", pixel)
        self.do("LeftButtonPressEvent", pixel)
        self.do("LeftButtonReleaseEvent", pixel)

    def drag(self, one, other):
        start, end = self.pixel(one), self.pixel(other)
        self.do("MouseMoveEvent", start)
        self.do("LeftButtonPressEvent", start)
        for k in range(1, 11):
            self.do("MouseMoveEvent", [round(a + (b - a) * k / 10) for a, b in zip(start, end)])
        self.do("LeftButtonReleaseEvent", end)


def clicked(filter):
    return [tuple(filter.Points[k:k + 3]) for k in range(0, len(filter.Points), 3)]


def near(a, b):
    return math.dist(a, b) < 0.05


def until(condition, what):
    """Waits up to two minutes, since the machine may be busy."""
    for _ in range(1200):
        if condition():
            return
        yield
    raise AssertionError(f"Waited in vain until {what}.")


def look(view, z):
    """Looks at the origin from a place on the z axis."""
    view.CameraPosition = [0, 0, z]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 1, 0]
    pv.Render(view)


def ball(x, y):
    """A point on the unit sphere, on the side of +z."""
    return (x, y, math.sqrt(1 - x * x - y * y))


def forward(representation):
    """The depth offset by which lines are drawn in front."""
    shown = representation.SMProxy.GetClientSideObject().GetActiveRepresentation()
    factor, units = reference(0.0), reference(0.0)
    shown.GetActor().GetMapper().GetRelativeCoincidentTopologyLineOffsetParameters(factor, units)
    return -units


def balls_at_ends(view):
    """Whether the last point is shown as a ball; ParaView's cone would point along the line, often into the
    mesh."""
    props = view.GetRenderer().GetViewProps()
    drawings = [props.GetItemAsObject(k) for k in range(props.GetNumberOfItems())
                if props.GetItemAsObject(k).IsA("vtkCurveRepresentation")]
    return len(drawings) == 1 and not drawings[0].GetDirectional()


def steps():
    """The actions of the test; each yield lets ParaView run."""
    pv.GetSettingsProxy("GeneralSettings").AutoApply = 1
    sphere = pv.Sphere(Radius=1, ThetaResolution=64, PhiResolution=64)
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.Show(sphere, view)
    look(view, 6)
    yield
    filter = pv.TalwegSmoothPoints(Mesh=sphere, Points=[c for p in ((-0.5, 0), (0, 0.3), (0.5, 0))
                                                        for c in ball(*p)])
    curves = pv.Show(filter, view)
    pv.SetActiveSource(filter)
    pv.Render(view)
    hand = Hand(view)
    for _ in range(10):
        yield

    assert forward(curves) > 100, "half of a wide line would be behind slopes"
    view.CameraPosition = [0.9, 0.9, 0.9]  # beside the ball, in its box, where the range of depth begins at
                                           # the camera
    pv.Render(view)
    assert 0 < forward(curves) < 50, "the line would be seen through the mesh"
    look(view, 6)

    assert balls_at_ends(view), "the cone of the last point is in the mesh"

    hand.click(ball(0.4, -0.5))
    yield from until(lambda: len(clicked(filter)) == 4, "a click adds a point")
    assert near(clicked(filter)[3], ball(0.4, -0.5)), clicked(filter)
    hand.drag(ball(0.4, -0.5), ball(0.2, -0.6))
    yield from until(lambda: near(clicked(filter)[3], ball(0.2, -0.6)), "a point is dragged")
    assert len(clicked(filter)) == 4

    # The line between the points is inside the ball; the visible curve is on the ball.
    curve = pv.servermanager.Fetch(filter, idx=0)
    places = [curve.GetPoint(k) for k in range(curve.GetNumberOfPoints())]
    third = min(range(len(places)), key=lambda k: math.dist(places[k], ball(0.5, 0)))
    middle = places[(third + len(places)) // 2]
    chord = [(a + b) / 2 for a, b in zip(*clicked(filter)[2:])]
    assert math.dist(hand.pixel(middle), hand.pixel(chord)) > 8, "the curve is beside its line"
    hand.drag(middle, ball(0.6, -0.5))
    yield from until(lambda: len(clicked(filter)) == 5, "dragging the curve makes a point")
    assert near(clicked(filter)[3], ball(0.6, -0.5)), clicked(filter)

    # In a view from behind, points on the far side cannot be grabbed.
    before = clicked(filter)
    look(view, -6)
    yield
    hand.drag(before[1], (before[1][0] + 0.1, *before[1][1:]))
    for _ in range(10):
        yield
    assert clicked(filter) == before, (before, clicked(filter))


def run(work, interactor):
    """Runs a step on each call; ends the program after the last."""

    def step(*_):
        try:
            next(work)
        except StopIteration:
            print("The drawing works in its window.", flush=True)
            os._exit(0)
        except BaseException:  # the timer must not continue after a failure
            traceback.print_exc()
            sys.stderr.flush()
            os._exit(1)

    interactor.AddObserver("TimerEvent", step)
    interactor.CreateRepeatingTimer(100)


run(steps(), pv.GetActiveViewOrCreate("RenderView").GetInteractor())
