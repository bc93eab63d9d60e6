"""Operators that run long work on a thread while Blender stays usable. The status bar shows the progress; Esc
ends the work."""

import bpy

from . import jobs, last_report, session
from .package import talweg

#: Events that are passed on to Blender while a job runs, so that the view can be turned.
_NAVIGATION = ("MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "MOUSEMOVE", "TRACKPADPAN", "TRACKPADZOOM")


class LongOperator:
    """Base of operators with long work.

    A press of a button starts a job and waits a moment for it, so that a short job needs no modal phase.
    Scripts and the redo panel wait for the end of the job.

    A derived class has ``steps(context, obj)``, a generator as in jobs.py that returns a sentence and
    warnings, and ``subject(context)``, the object whose mesh the steps change.
    """

    def execute(self, context):
        obj = self.subject(context)
        return self._reported(obj.name, lambda: jobs.now(self.steps(context, obj)))

    def invoke(self, context, _event):
        if bpy.app.background or context.window is None:
            return self.execute(context)
        self._timer, self._status, obj = None, "", self.subject(context)
        self._name = obj.name
        self._steps = self.steps(context, obj)
        try:
            self._job = jobs.Job(next(self._steps))
        except (talweg.Error, KeyboardInterrupt) as error:
            return self._refused(error)
        self._watched = session.Watched(context, obj)
        if self._job.is_done(wait=0.3):
            return self._finish(context)
        manager = context.window_manager
        self._timer = manager.event_timer_add(0.1, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"INFO"}, f"{self.bl_label} was stopped; the mesh is as it was.")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if event.type in _NAVIGATION else {"RUNNING_MODAL"}
        if self._job.is_done():
            return self._finish(context)
        line = f"{self.bl_label}: {self._job.status}   |   Esc: stop"
        if line != self._status:  # each text causes a redraw
            self._status = line
            context.workspace.status_text_set(line)
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        """Blender calls cancel() at its end; modal() calls it at Esc."""
        self._job.stop()
        self._clear(context)

    def _clear(self, context):
        self._watched.end()
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            context.workspace.status_text_set(None)

    def _finish(self, context):
        self._clear(context)
        if self._watched.has_changed:  # changed in another window, or by a script
            return self._refused("The mesh was changed meanwhile; try again.")
        return self._reported(self._name, lambda: jobs.after(self._steps, self._job.result))

    def _refused(self, error):
        self.report({"ERROR"}, str(error) or "Interrupted.")
        return {"CANCELLED"}

    def _reported(self, name, work):
        try:
            done, warnings = work()
        except (talweg.Error, KeyboardInterrupt) as error:
            return self._refused(error)
        # One report for all: of several reports the status bar shows only the last.
        self.report({"WARNING"} if warnings else {"INFO"}, " ".join([done, *warnings]))
        last_report.note(name, done, warnings)
        return {"FINISHED"}
