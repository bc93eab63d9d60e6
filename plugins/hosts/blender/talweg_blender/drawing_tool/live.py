"""Smooths on a thread of its own while the user draws. The newest request replaces the waiting one."""

import threading
from typing import Any, NamedTuple, Optional

from ..package import talweg


class Request(NamedTuple):
    curves: list
    values: dict
    fields: dict = {}
    preview: bool = False  # smooth only the stretch that is being dragged
    tag: Any = None  # returned with the answer


class Answer(NamedTuple):
    request: Request
    result: Any = None
    error: Optional[Exception] = None


class Live:
    """The thread, which owns a workspace of an opened mesh."""

    def __init__(self, mesh):
        self._workspace = mesh.workspace()
        self._changed = threading.Condition()
        self._asked = self._at_work = self._answer = None
        self._ends = False
        self._thread = threading.Thread(target=self._run, name="talweg", daemon=True)
        self._thread.start()

    def ask(self, request):
        """Sets the request that the thread takes next; a waiting request is dropped."""
        with self._changed:
            self._asked = request
            self._changed.notify_all()

    def poll(self):
        """The newest answer, which is given once; None if there is no new one."""
        with self._changed:
            answer, self._answer = self._answer, None
            return answer

    def wait(self):
        """The answer to the newest request; None if all answers were given. The run for an earlier request is
        cancelled."""
        with self._changed:
            if self._asked is not None and self._at_work is not None:
                self._workspace.cancel()
            self._changed.wait_for(lambda: self._asked is None and self._at_work is None)
        return self.poll()

    @property
    def is_busy(self):
        with self._changed:
            return self._asked is not None or self._at_work is not None

    def close(self):
        """Cancels the run and ends the thread; there is no answer."""
        with self._changed:
            self._ends, self._asked = True, None
            self._changed.notify_all()
        self._workspace.cancel()
        self._thread.join(10)

    def _run(self):
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._asked is not None or self._ends)
                if self._ends:
                    return
                self._at_work, self._asked = self._asked, None
            answer = self._answered(self._at_work)
            with self._changed:
                self._answer, self._at_work = answer, None
                self._changed.notify_all()

    def _answered(self, request):
        try:
            self._workspace.set_curves(request.curves)
            result = self._workspace.smooth(preview=request.preview, **request.values, **request.fields)
        except talweg.Error as error:
            return Answer(request, error=error)
        except Exception as error:  # an error of any kind must reach the tool, which waits for an answer
            return Answer(request, error=talweg.Internal(f"{type(error).__name__}: {error}"))
        return Answer(request, result)
