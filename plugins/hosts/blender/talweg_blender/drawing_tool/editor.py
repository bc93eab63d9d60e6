"""Edits of a drawing, each of which can be undone."""

from typing import NamedTuple, Tuple

from . import lines
from .lines import Line


class State(NamedTuple):
    lines: Tuple[Line, ...] = ()
    tau: float = 1.0


class Editor:
    """A drawing and its history. What a hand does between press and release is one step."""

    def __init__(self, state=State()):
        self.state = state
        self._past, self._future = [], []
        self._before = None  # the state at the press of a hand

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
        """What follows until release() is one step."""
        self._before = self.state

    def release(self):
        before, self._before = self._before, None
        if before is not None and before != self.state:
            self._past.append(before)
            self._future = []

    def take_back(self):
        """As it was at the press."""
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
        """The number of the line that clicks go on with, or None."""
        last = len(self.lines) - 1
        return last if last >= 0 and not self.lines[last].finished else None

    def begin(self, point):
        """A line of its own from here."""
        self.finish()
        self._become(self.state._replace(lines=self.lines + (Line((point,)),)))

    def append(self, point):
        """To the line that is being drawn, or to a new one; what is there already is not drawn twice."""
        number = self.unfinished
        if number is None:
            self.begin(point)
        elif lines.distance(self.lines[number].points[-1], point) > 0:
            line = self.lines[number]
            self._replaced(number, line._replace(points=line.points + (point,)))

    def go_on(self, number, at_start=False):
        """Clicks and strokes go on at an end of this line, which becomes the last one."""
        self.finish()
        line = self.lines[number]
        line = line._replace(points=line.points[::-1] if at_start else line.points, finished=False)
        others = self.lines[:number] + self.lines[number + 1:]
        self._become(self.state._replace(lines=others + (line,)))

    def finish(self):
        """What is drawn next is another line; a single point is none."""
        number = self.unfinished
        if number is not None:
            line = self.lines[number]
            self._replaced(number, line._replace(finished=True) if len(line.points) > 1 else None)

    def close(self, number, closed=True):
        """Back to its first point, if it has three."""
        line = self.lines[number]
        if closed and len(line.points) < 3:
            return
        self._replaced(number, line._replace(closed=closed, finished=True))

    # ---- Points.

    def insert(self, number, before, point):
        self._replaced(number, lines.inserted(self.lines[number], before, point))

    def move(self, number, at, point, start):
        """From a line as it was at the press."""
        self._replaced(number, lines.bent(start, at, point))

    def remove(self, number, at):
        self._replaced(number, lines.without(self.lines[number], at))

    def remove_last(self):
        """Of the line that is being drawn, else the last line."""
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
        """Equal when the result is the same."""
        return [(line.points, line.closed) for line in self.lines if line.is_curve], self.state.tau

    def curves(self):
        """talweg.Curves, and the line of each."""
        numbers = [number for number, line in enumerate(self.lines) if line.is_curve]
        return [self.lines[number].curve() for number in numbers], numbers
