"""Turns presses, moves and releases of the mouse on a view into edits. Knows no window and no event of
Blender."""

import numpy as np

from . import lines, view as seen
from .editor import Editor, State
from .lines import Line

#: Pixels: reach of a handle, reach of the curve, the move that makes a press a stroke, distance of stroke
#: points.
_HANDLE, _CURVE, _STILL, _STEP = 10, 7, 4, 3


class Work:
    """A drawing with its result and the state of the mouse. ``changed`` is called after each change.

    :param ground: finds points of the surface.
    """

    def __init__(self, ground, state=State(), changed=lambda: None):
        self.ground = ground
        self.editor = Editor(state)
        self.changed = changed
        self.results = []  # points (k, 3) of each result; ``of_lines`` has its line
        self.of_lines = []
        self.hand = None  # the action of the pressed mouse, or None
        self.under = None  # (line, point) under the resting mouse, or None
        self.clicked = ""  # the kind of the last click: "point", "pin" or "handle"

    # ---- What is seen.

    def handles(self):
        """(line, point) of each handle: exact points, and the ends of open lines."""
        return [(number, k) for number, line in enumerate(self.editor.lines)
                for k, point in enumerate(line.points)
                if point.exact or not line.closed and k in (0, len(line.points) - 1)]

    def show(self, curves, of_lines):
        """Takes the curves of a result, and the line of each."""
        self.results = [np.asarray(curve.positions) for curve in curves]
        self.of_lines = list(of_lines)

    def handle_at(self, view, mouse):
        """The (line, point) of the handle under the mouse, or None."""
        among = self.handles()
        if not among:
            return None
        places = [self.editor.lines[line].points[k].position for line, k in among]
        near = seen.nearest_point(view.project(places), mouse, _HANDLE)
        return next((among[k] for k in near if self.ground.sees(view, places[k])), None)

    def curve_at(self, view, mouse):
        """The place of the result under the mouse as (line, index at which a new point would be inserted,
        Point), or None."""
        best = None
        for along, number in zip(self.results, self.of_lines):
            if number >= len(self.editor.lines):
                continue
            found = seen.nearest_segment(view.project(along), self.editor.lines[number].closed, mouse, _CURVE)
            if found and (best is None or found[2] < best[1][2]):
                best = number, found, along
        if best is None:
            return None
        number, (segment, t, _), along = best
        position = along[segment] * (1 - t) + along[(segment + 1) % len(along)] * t
        if not self.ground.sees(view, position):
            return None
        before = lines.place_on(self.editor.lines[number], along, segment)
        return number, before, self.ground.nearest(position, exact=True)

    # ---- The hand.

    def press(self, view, mouse, alone=False):
        """Begins an action. Returns whether there is one.

        :param alone: handles and curves under the mouse are left alone.
        """
        self.editor.press()
        handle = None if alone else self.handle_at(view, mouse)
        if handle:
            self.hand = _OnHandle(self, mouse, *handle)
            return True
        on_curve = None if alone else self.curve_at(view, mouse)
        if on_curve:
            number, before, point = on_curve
            self.editor.insert(number, before, point)
            self.hand = _OnHandle(self, mouse, number, before, inserted=True)
            return True
        point = self.ground.hit(view.ray(mouse), exact=True)
        if point is None:
            self.editor.release()
            return False
        self.hand = _Drawing(self, mouse, point)
        return True

    def move(self, view, mouse):
        """Continues the action. Returns whether something changed."""
        if self.hand is None:
            self.under = self.handle_at(view, mouse)
            return False
        did = self.hand.move(view, mouse)
        if did:
            self.changed()
        return did

    def release(self, view, mouse):
        hand, self.hand = self.hand, None
        if hand is not None:
            hand.release(view, mouse)
            self.editor.release()
            self.changed()

    def drop_hand(self):
        """Cancels the action of the pressed mouse."""
        if self.hand is not None:
            self.hand = None
            self.editor.take_back()
            self.changed()

    @property
    def is_dragging(self):
        return isinstance(self.hand, _OnHandle)

    # ---- Keys.

    def pin(self, view, mouse):
        """Pins the curve under the mouse; removes the handle if there is one."""
        handle = self.handle_at(view, mouse)
        if handle:
            self.editor.remove(*handle)
        else:
            on_curve = self.curve_at(view, mouse)
            if on_curve is None:
                return
            self.editor.insert(*on_curve)
        self.changed()

    def double_click(self, view, mouse):
        """The second click of a double click. On a new way-point it ends the line; on a handle it acts as
        pin()."""
        if self.clicked == "point":
            self.next_line()
        elif self.clicked == "handle":
            self.pin(view, mouse)

    def remove(self, view, mouse):
        """Removes the handle under the mouse, or the last drawn point."""
        handle = self.handle_at(view, mouse)
        if handle:
            self.editor.remove(*handle)
        else:
            self.editor.remove_last()
        self.changed()

    def close(self):
        """Closes the last line of the drawing, or opens it if it is closed."""
        number = len(self.editor.lines) - 1
        if number >= 0:
            self.editor.close(number, not self.editor.lines[number].closed)
            self.changed()

    def next_line(self):
        self.editor.finish()
        self.changed()

    def undo(self):
        self.editor.undo()
        self.changed()

    def redo(self):
        self.editor.redo()
        self.changed()

    def turn(self, steps):
        """The mouse wheel: a step multiplies or divides tau by 1.25."""
        tau = self.editor.state.tau
        tau = max(tau, 0.05) * 1.25 ** steps if tau or steps > 0 else 0.0
        self.editor.set_tau(0.0 if tau < 0.05 else min(tau, 100.0))
        self.changed()


def _is_still(mouse, start):
    return np.linalg.norm(np.subtract(mouse, start)) < _STILL


class _OnHandle:
    """An action on a handle: a drag moves its point. A click on the first point of the unfinished line closes
    the line; a click on an end of another line continues that line."""

    def __init__(self, work, mouse, number, at, inserted=False):
        self.work, self.start, self.number, self.at = work, mouse, number, at
        self.inserted, self.moved = inserted, False
        self.line = work.editor.lines[number]

    def move(self, view, mouse):
        if not self.moved and _is_still(mouse, self.start):
            return False
        self.moved = True
        point = self.work.ground.hit(view.ray(mouse), exact=True)
        if point is None:
            return False
        self.work.editor.move(self.number, self.at, point, self.line)
        return True

    def release(self, _view, _mouse):
        self.work.clicked = "" if self.moved else "pin" if self.inserted else "handle"
        if self.moved or self.inserted:
            return
        editor, line = self.work.editor, self.line
        is_start, is_end = self.at == 0, self.at == len(line.points) - 1
        if self.number == editor.unfinished:
            if is_start and len(line.points) > 2:
                editor.close(self.number)
        elif not line.closed and (is_start or is_end):
            editor.go_on(self.number, is_start)


class _Drawing:
    """An action on the mesh: a click adds a way-point, a drag paints a stroke."""

    def __init__(self, work, mouse, point):
        self.work, self.start, self.first = work, mouse, point
        self.last = mouse
        self.is_stroke = False

    def move(self, view, mouse):
        if not self.is_stroke and _is_still(mouse, self.start):
            return False
        if self.is_stroke and np.linalg.norm(np.subtract(mouse, self.last)) < _STEP:
            return False
        point = self.work.ground.hit(view.ray(mouse), exact=False)
        if point is None:
            return False
        editor = self.work.editor
        if not self.is_stroke:
            self.is_stroke = True
            editor.append(self.first._replace(exact=False))  # joins the stroke to the clicks before it
        line = editor.lines[-1]
        step = min(0.5 * self.work.ground.surface.edge, 8 * view.pixel_at(point.position))
        if lines.distance(line.points[-1], point) >= step:
            editor.append(point)
        self.last = mouse
        return True

    def release(self, view, mouse):
        editor = self.work.editor
        self.work.clicked = "" if self.is_stroke else "point"
        if not self.is_stroke:
            editor.append(self.first)
            return
        line = editor.lines[-1]
        ends = view.project([line.points[0].position, line.points[-1].position])
        if len(line.points) > 8 and np.linalg.norm(ends[1] - ends[0]) <= _HANDLE:
            editor.close(len(editor.lines) - 1)
        elif not any(point.exact for point in line.points):
            editor.finish()


def lines_of(curves, ground):
    """Lines of talweg.Curves as they were drawn: given by vertices, by faces with barycentrics, or by
    positions."""
    return tuple(Line(tuple(_points(curve, ground)), bool(curve.closed), True) for curve in curves)


def _points(curve, ground):
    count = len(curve)
    exact = [False] * count if curve.exact is None else (np.asarray(curve.exact) >= 0).tolist()
    if curve.vertices is None and curve.faces is not None:
        return [ground.at(face, weights, is_exact)
                for face, weights, is_exact in zip(curve.faces, curve.barycentrics, exact)]
    positions = curve.positions if curve.vertices is None else \
        ground.surface.arrays.vertices[np.asarray(curve.vertices)]
    return [ground.nearest(position, is_exact) for position, is_exact in zip(positions, exact)]
