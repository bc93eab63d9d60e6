"""Work of the library that may take long, on a thread of its own, so that Blender lives meanwhile.

What needs it is written as a generator: it yields the work, a function of a progress callback, once, gets
what the work gave, and returns.
"""

import threading
import time

from .package import talweg


def now(steps):
    """What such a generator returns; the work is done here, and Blender waits."""
    work = next(steps)
    return after(steps, lambda: work(None))


def after(steps, give):
    """What it returns. An error of its work reaches it, too: it may know more of it.

    :param give: gives what the work gave, or raises what ended it.
    """
    try:
        try:
            given = give()
        except BaseException as error:
            steps.throw(error)
        else:
            steps.send(given)
    except StopIteration as end:
        return end.value
    raise AssertionError("the steps yield once")


class Job:
    """Such work; it begins at once. It must not touch Blender's data."""

    def __init__(self, work):
        self._at, self._began = "", time.monotonic()
        self._work, self._given, self._error = work, None, None
        self._stopped = False
        self._thread = threading.Thread(target=self._run, name="talweg", daemon=True)
        self._thread.start()

    def _run(self):
        try:
            self._given = self._work(self._progress)
        except talweg.Error as error:
            self._error = error
        except Exception as error:  # a fault of ours must not leave Blender waiting
            self._error = talweg.Internal(f"{type(error).__name__}: {error}")

    def _progress(self, stage, fraction):
        self._at = f"{stage} {100 * fraction:.0f} %, "
        return not self._stopped

    @property
    def told(self):
        """How far it is, and for how long it has been at work: some stages tell nothing meanwhile."""
        return f"{self._at}{time.monotonic() - self._began:.0f} s"

    def is_done(self, wait=0.0):
        """:param wait: at most so many seconds for it."""
        self._thread.join(wait)
        return not self._thread.is_alive()

    def given(self):
        """What it gave; raises the talweg.Error that ended it."""
        if self._error is not None:
            raise self._error
        return self._given

    def stop(self):
        """It ends soon. Nobody waits for that: what it gives is dropped."""
        self._stopped = True
