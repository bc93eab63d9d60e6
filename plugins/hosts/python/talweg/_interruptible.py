"""Long calls that Ctrl-C ends.

Python runs signal handlers on the main thread only, and only between its own instructions. A call from the
main thread therefore runs on a thread of its own, while the main thread waits, where Ctrl-C reaches it at
once. The main thread then cancels the work, and raises KeyboardInterrupt after its end. A second Ctrl-C
abandons work that does not end, such as a faulty plugin's.
"""

from __future__ import annotations

import queue
import threading
import time
from typing import Any, Callable, NamedTuple, Optional

from ._types import Progress


class _Bar:
    """A tqdm bar as a callback; each stage moves the bar from 0 to its total."""

    def __init__(self, bar: Any) -> None:
        self.bar = bar

    def __call__(self, stage: str, fraction: float) -> None:
        self.bar.set_description(stage, refresh=False)
        self.bar.n = fraction * (self.bar.total or 1)
        self.bar.refresh()

    def done(self) -> None:
        self("done", 1.0)


def as_progress(progress: Any) -> Optional[Progress]:
    """A callback unchanged; a tqdm bar as a callback that moves it."""
    if progress is None or callable(progress):
        return progress  # type: ignore[no-any-return]
    if hasattr(progress, "refresh") and hasattr(progress, "set_description"):
        return _Bar(progress)
    raise TypeError("progress must be a function (stage, fraction) or a tqdm bar, not "
                    f"{type(progress).__name__}")


class _Task:
    def __init__(self, work: Callable[[Optional[Progress]], Any], with_progress: bool) -> None:
        self.work = work
        self.with_progress = with_progress
        self.messages: "queue.SimpleQueue[Any]" = queue.SimpleQueue()
        self.answers: "queue.SimpleQueue[bool]" = queue.SimpleQueue()
        self.running = False
        self.abandoned = False
        self.done = threading.Event()
        self.result: Any = None
        self.error: Optional[BaseException] = None

    def ask(self, stage: str, fraction: float) -> bool:
        self.messages.put((stage, fraction))
        return self.answers.get()

    def run(self) -> None:
        self.running = True
        try:
            if not self.abandoned:
                self.result = self.work(self.ask if self.with_progress else None)
        except BaseException as error:  # raised again on the main thread
            self.error = error
        finally:
            self.running = False
            self.done.set()
            self.messages.put(None)


class Ends(NamedTuple):
    """How work is ended early."""

    cancel: Callable[[], None]  #: asks the work to end
    give_up: Callable[[], None]  #: is called when the work is abandoned


_TWICE_IS_MEANT = 0.5  # seconds within which a second Ctrl-C does not count: timeout(1) and others send the
                       # signal twice


def _stop(task: _Task, ends: Ends) -> None:
    """Waits for the end of the work after a cancel. The cancel is repeated, since one before the start of the
    plugin's run is lost. Another Ctrl-C abandons the work."""
    began = time.monotonic()
    while True:
        try:
            task.abandoned = True
            while task.running and not task.done.wait(0.02):
                task.answers.put(False)
                ends.cancel()
            return
        except KeyboardInterrupt:
            if time.monotonic() - began >= _TWICE_IS_MEANT:
                ends.give_up()
                return


def call(work: Callable[[Optional[Progress]], Any], ends: Ends,
         progress: Optional[Progress]) -> Any:
    """Runs work(progress) with progress called on the caller's thread. An exception of progress, or Ctrl-C,
    ends the work and is raised by call()."""
    if threading.current_thread() is threading.main_thread():
        result = _interruptibly(work, ends, progress)
    else:
        result = work(progress)
    if isinstance(progress, _Bar):
        progress.done()
    return result


def _interruptibly(work: Callable[[Optional[Progress]], Any], ends: Ends,
                   progress: Optional[Progress]) -> Any:
    task = _Task(work, progress is not None)
    try:
        threading.Thread(target=task.run, name="talweg", daemon=True).start()
        while True:
            try:
                message = task.messages.get(timeout=0.1)
            except queue.Empty:  # timeouts let Python handle signals that arrived on another thread
                continue
            if message is None:
                break
            assert progress is not None
            task.answers.put(progress(*message) is not False)
    except BaseException:
        _stop(task, ends)
        raise
    if task.error is not None:
        raise task.error.with_traceback(None)  # frames of the other thread would not help the user
    return task.result
