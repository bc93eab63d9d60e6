"""Edits of a drawing, with undo."""

from typing import NamedTuple, Tuple

from . import lines
from .lines import Line


class State(NamedTuple):
    lines: Tuple[Line, ...] = ()
    tau: float = 1.0


class Editor:
    """A drawing and its history. All edits between press() and release() are one step of undo."""

    def __init__(self, state=State()):
        self.state = state
        self._past, self._future = [], []
        self._before = None  # the state at the last press()

    @property
    def lines(self):
        return self.state.lines

    def _become(self, state):
        if state == self.state:
            return
        if self._before is None:
            self._past.append(self.state)
            self._future = []
        self.state = state

    def _replaced(self, number, line):
        found = list(self.lines)
        found[number:number + 1] = [line] if line is not None else []
        self._become(self.state._replace(lines=tuple(found)))

    # ---- The hand.

    def press(self):
        """Begins a step of undo, which release() ends."""
        self._before = self.state

    def release(self):
        before, self._before = self._before, None
        if before is not None and before != self.state:
            self._past.append(before)
            self._future = []

    def take_back(self):
        """Restores the state at the last press()."""
        if self._before is not None:
            self.state, self._before = self._before, None

    def undo(self):
        if self._past:
            self._future.append(self.state)
            self.state = self._past.pop()

    def redo(self):
        if self._future:
            self._past.append(self.state)
            self.state = self._future.pop()

    # ---- Lines.

    @property
    def unfinished(self):
        """The number of the line that the next click extends, or None."""
        last = len(self.lines) - 1
        return last if last >= 0 and not self.lines[last].finished else None

    def begin(self, point):
        """Begins a new line at this point."""
        self.finish()
        self._become(self.state._replace(lines=self.lines + (Line((point,)),)))

    def append(self, point):
        """Adds a point to the unfinished line, or begins a line with it. A point at the end of the line is
        not repeated."""
        number = self.unfinished
        if number is None:
            self.begin(point)
        elif lines.distance(self.lines[number].points[-1], point) > 0:
            line = self.lines[number]
            self._replaced(number, line._replace(points=line.points + (point,)))

    def go_on(self, number, at_start=False):
        """Makes the line unfinished, so that clicks and strokes extend it at its end or at its start. The
        line becomes the last of the drawing."""
        self.finish()
        line = self.lines[number]
        line = line._replace(points=line.points[::-1] if at_start else line.points, finished=False)
        others = self.lines[:number] + self.lines[number + 1:]
        self._become(self.state._replace(lines=others + (line,)))

    def finish(self):
        """Finishes the line: the next point begins another one. A line of a single point is removed."""
        number = self.unfinished
        if number is not None:
            line = self.lines[number]
            self._replaced(number, line._replace(finished=True) if len(line.points) > 1 else None)

    def close(self, number, closed=True):
        """Closes or opens a line. A line with fewer than three points stays open."""
        line = self.lines[number]
        if closed and len(line.points) < 3:
            return
        self._replaced(number, line._replace(closed=closed, finished=True))

    # ---- Points.

    def insert(self, number, before, point):
        self._replaced(number, lines.inserted(self.lines[number], before, point))

    def move(self, number, at, point, start):
        """Moves a point of ``start``, the line at the last press()."""
        self._replaced(number, lines.bent(start, at, point))

    def remove(self, number, at):
        self._replaced(number, lines.without(self.lines[number], at))

    def remove_last(self):
        """Removes the last point of the unfinished line; without one, the last line."""
        number = self.unfinished
        if number is not None:
            self.remove(number, len(self.lines[number].points) - 1)
        elif self.lines:
            self._replaced(len(self.lines) - 1, None)

    def set_tau(self, tau):
        self._become(self.state._replace(tau=tau))

    # ---- For Talweg.

    @property
    def drawn(self):
        """A value that is equal for drawings with the same result."""
        return [(line.points, line.closed) for line in self.lines if line.is_curve], self.state.tau

    def curves(self):
        """The talweg.Curves of the drawing, and the number of the line of each."""
        numbers = [number for number, line in enumerate(self.lines) if line.is_curve]
        return [self.lines[number].curve() for number in numbers], numbers
