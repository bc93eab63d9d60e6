"""The state of the tool in a scene: a drawing, the thread that smooths it, and the curve object with the
result."""

import json

import bpy

from .. import colours, curve_object, jobs, outcomes, parameters, resmoothing, sentences, session, settings
from ..naming import named
from ..package import talweg
from .editor import State
from .ground import Ground
from .live import Live, Request
from .work import Work, lines_of


class Drawn:
    """A drawing that is being edited. Until finish() or drop() only its curve object changes.

    Objects are looked up by name, since Blender's undo replaces them.
    """

    def __init__(self, context, obj, curve=None, output="CURVE", repair=False):
        """:param curve: the curve object of an earlier drawing to edit; None: a new drawing.
        :raises talweg.Error: if nothing can be drawn on the mesh.
        """
        self.is_new = curve is None
        self.output = output
        as_shown = output == "CURVE" if self.is_new else settings.of(curve).as_shown
        if output != "CURVE" and session.is_changed(obj):
            raise talweg.BadUsage(f"{obj.name} has modifiers or shape keys; apply them first, or choose "
                                  "Curve object.")
        repair = repair if self.is_new else settings.of(curve).repair
        outcomes.check(output, repair)
        self.place = session.surface_of(context, obj, as_shown)
        self.live = Live(self.place.mesh(repair))
        self.object_name = obj.name
        self.as_shown = as_shown
        self.error = ""  # of the last answer; empty: none
        self.summary = ""
        self.decisive = ""  # the decisive warnings of the result, by which it may be of no use
        self.result = None
        ground = Ground(self.place, self._shown)
        if self.is_new:
            curve = curve_object.new(context, obj)
            settings.keep(curve, None, [], self.place, as_shown)
            with settings.quietly():
                settings.of(curve).repair = repair
                parameters.show_used(settings.of(curve))
            state = State(tau=settings.of(curve).tau)
        else:
            state = State(lines_of(settings.drawn_on(curve, self.place), ground), settings.of(curve).tau)
            self._before = _saved(curve)
        self.curve_name = curve.name
        self._asked = None  # the drawing of the last request
        self._begun = state
        self.work = Work(ground, state, self.ask)
        resmoothing.others.append(self._take)
        if not self.is_new:
            self.ask()

    # ---- The scene.

    @property
    def object(self):
        return bpy.data.objects.get(self.object_name)

    @property
    def curve(self):
        return bpy.data.objects.get(self.curve_name)

    @property
    def is_there(self):
        """Whether the mesh and the curve object still exist."""
        return self.object is not None and self.curve is not None

    def _shown(self):
        return self.object.evaluated_get(bpy.context.evaluated_depsgraph_get())

    def _take(self, _context, curve):
        """Takes values that the user changed in the sidebar. Returns whether the curve belongs to the
        tool."""
        if curve.name != self.curve_name:
            return False
        self.work.editor.set_tau(settings.of(curve).tau)
        self.ask()
        return True

    # ---- Results.

    def ask(self):
        """Requests the result of the current drawing; poll() shows it."""
        curves, of_lines = self.work.editor.curves()
        kept = settings.of(self.curve)
        with settings.quietly():
            kept.tau = self.work.editor.state.tau
        if not curves:
            self._empty()
            return
        self._asked = None if self.work.is_dragging else self.work.editor.drawn
        self.live.ask(Request(curves, parameters.values(kept), colours.wanted_fields(kept),
                              self.work.is_dragging, of_lines))

    def _empty(self):
        self.result, self.error, self.summary, self.decisive = None, "", "", ""
        self.work.show([], [])
        self.curve.data.splines.clear()
        self.curve.pop("talweg_report", None)
        colours.remove(self.curve)

    def poll(self):
        """Shows the newest answer. Returns whether there was one."""
        return self._shows(self.live.poll())

    def wait(self):
        """Waits for the answer to the last request and shows it, as poll()."""
        return self._shows(self.live.wait())

    def _shows(self, answer):
        if answer is None:
            return False
        self.error = str(answer.error or "")
        if answer.error is not None or not self.work.editor.curves()[0]:
            return True
        self.result = answer.result
        self.work.show(answer.result.curves, answer.request.tag)
        with settings.quietly():
            parameters.show_used(settings.of(self.curve), answer.result.total)
        curve_object.write(self.curve, self.place, answer.result)
        self.summary = sentences.of_result(bpy.context, answer.result)
        self.decisive = " ".join(answer.result.total.decisive)
        return True

    # ---- The end.

    def finish(self, context):
        """Ends with the result in the scene. Returns a sentence, and warnings.

        :raises talweg.Error: if there is no result; nothing changes then.
        """
        self.work.editor.finish()
        if self._asked != self.work.editor.drawn:
            self.ask()
        self.wait()
        if self.error:
            raise talweg.BadCurve(self.error)
        if self.result is None:
            raise talweg.BadCurve("Nothing is drawn yet; a curve needs two points.")
        curve, obj = self.curve, self.object
        settings.keep(curve, None, self.result.drawn, self.place, self.as_shown)
        if "talweg_drawing" not in curve:
            curve["talweg_drawing"] = "tool " + curve.name
        self.place.know(curve["talweg_drawing"], self.result)
        warnings = [*self.result.total.decisive, *sentences.of_object(obj, self.as_shown),
                    *sentences.others_of(vars(self.result.total))]
        if self.output == "CURVE":
            self.close()
            return f"{self.summary} Curve: {curve.name}.", warnings
        with named([curve.name]):
            message, more = jobs.now(outcomes.of_mesh(context, obj, self.place, self.result, self.output))
        self.close()
        _remove(curve)
        return f"{self.summary} {message}".strip(), warnings + more

    def drop(self):
        """Ends without a result: an edited curve object gets its earlier values, a new one is removed."""
        curve = self.curve
        self.close()
        if curve is None:
            return
        if self.is_new:
            _remove(curve)
        else:
            _restore(bpy.context, curve, self._before)

    def close(self):
        if self._take in resmoothing.others:
            resmoothing.others.remove(self._take)
        self.live.close()


def _saved(curve):
    kept = settings.of(curve)
    names = [name for name in (*parameters.annotations(), *settings.own(None)) if not name.endswith("_in_edges")]
    return {name: getattr(kept, name) for name in names}


def _restore(context, curve, values):
    with settings.quietly():
        for name, value in values.items():
            setattr(settings.of(curve), name, value)
    resmoothing.smooth(context, curve)


def _remove(curve):
    colours.remove(curve)
    data = curve.data
    bpy.data.objects.remove(curve)
    if not data.users:
        bpy.data.curves.remove(data)
