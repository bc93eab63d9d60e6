"""Long work of the library on a thread of its own, so that Blender stays usable.

The caller is a generator ("steps"). It yields the work once, a function of a progress callback; is resumed
with the result of the work; and returns its own result.
"""

import threading
import time

from .package import talweg


def now(steps):
    """Runs the steps with their work on this thread; returns the result of the generator."""
    work = next(steps)
    return after(steps, lambda: work(None))


def after(steps, give):
    """Resumes the generator with the result of the work; returns the generator's result. An error of the work
    is thrown into the generator, which may add to its sentence.

    :param give: returns the result of the work, or raises its error.
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
    """Work on a thread, which starts at once. The work must not touch Blender's data."""

    def __init__(self, work):
        self._at, self._began = "", time.monotonic()
        self._work, self._result, self._error = work, None, None
        self._stopped = False
        self._thread = threading.Thread(target=self._run, name="talweg", daemon=True)
        self._thread.start()

    def _run(self):
        try:
            self._result = self._work(self._progress)
        except talweg.Error as error:
            self._error = error
        except Exception as error:  # an error of any kind must end the wait of Blender
            self._error = talweg.Internal(f"{type(error).__name__}: {error}")

    def _progress(self, stage, fraction):
        self._at = f"{stage} {100 * fraction:.0f} %, "
        return not self._stopped

    @property
    def status(self):
        """The progress and the seconds since the start, for the status bar: some stages report no
        progress."""
        return f"{self._at}{time.monotonic() - self._began:.0f} s"

    def is_done(self, wait=0.0):
        """Whether the work has ended.

        :param wait: seconds to wait for the end.
        """
        self._thread.join(wait)
        return not self._thread.is_alive()

    def result(self):
        """The result of the work; raises the talweg.Error that ended it."""
        if self._error is not None:
            raise self._error
        return self._result

    def stop(self):
        """Asks the work to end. Its result is dropped, and nothing waits for it."""
        self._stopped = True
