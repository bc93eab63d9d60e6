"""Operators that smooth selected edges, annotations, or lines of other objects on a mesh, with a redo
panel."""

import re

import bpy

from . import colours, drawings, outcomes, parameters, repair_offers, sentences, session, settings, strokes
from . import wrapped
from .naming import named
from .package import talweg


class _Smoothing:
    """The part of the operators that smooths a drawing and shows the result."""

    bl_options = {"REGISTER", "UNDO"}
    _is_invoked = False

    def smooth(self, context, objects, drawing_on, as_shown):
        """Smooths drawing_on(object, surface) for each object and shows the results. An error on one object
        does not stop the others; if all fail, the errors become an error report.

        :param as_shown: use the mesh with its modifiers.
        """
        done, first, later, wrong = [], [], [], []
        for obj in objects:
            label = f"{obj.name}: " if len(objects) > 1 else ""
            try:
                one = self._smooth_one(context, obj, drawing_on, as_shown)
            except (talweg.Error, KeyboardInterrupt) as error:
                wrong.append(label + (str(error) or "Interrupted."))
                continue
            done.append(label + one[0])
            first += [label + warning for warning in one[1]]
            later += [label + warning for warning in one[2]]
        self._first_of_all = [*wrong, *first] if done else []
        if not done:
            return self._refuse(context, wrong)
        self._tell(" ".join(done), [*self._first_of_all, *later])
        return {"FINISHED"}

    def _refuse(self, context, wrong):
        """Reports errors. A user gets them at the mouse pointer, with an offer to repair the mesh if there is
        one; a script gets an error."""
        offered = self._is_invoked and repair_offers.is_for(context.object)
        self.report({"WARNING" if offered else "ERROR"}, " ".join(wrong))
        if offered:
            repair_offers.popup(context, context.object)
        return {"CANCELLED"}

    def _smooth_one(self, context, obj, drawing_on, as_shown):
        """Returns the sentence of the result, the warnings of drawing and object, which are read first, and
        the other warnings; raises talweg.Error."""
        outcomes.check(self.output, self.repair)
        place = session.surface_of(context, obj, as_shown)
        self.mean_edge = place.edge
        drawing = drawing_on(obj, place)
        try:
            drawing, result = self._result(context, place, drawing)
            parameters.show_used(self, result.total)  # before the curve object takes the values over
            with named(drawing.names):
                made, warnings = outcomes.make(context, obj, place, drawing, result, self, as_shown)
        except talweg.BadMesh as error:
            raise talweg.BadMesh(repair_offers.note(obj, place, error, self.bl_idname)) from None
        repair_offers.forget(obj)
        self.scaled = "\n".join(sentences.of_scale(obj))
        return (f"{sentences.of_result(context, result)} {made}".strip(),
                [*drawing.warnings, *sentences.of_object(obj, as_shown)],
                [*warnings, *(one for one in sentences.warnings_of(vars(result.total))
                              if not _is_measured(one, drawing))])

    def _result(self, context, place, drawing):
        """Smooths the drawing. Strokes that the library refuses are left out, with warnings. Returns the
        smoothed part of the drawing, and the result."""
        manager = context.window_manager
        while True:
            manager.progress_begin(0, 1)
            try:
                with named(drawing.names):
                    return drawing, session.smooth(
                        place, drawing.curves, parameters.values(self), repair=self.repair,
                        key=drawing.key, progress=lambda stage, done: manager.progress_update(done),
                        **colours.wanted_fields(self))
            except talweg.BadCurve as error:
                drawing = _without(drawing, str(error))
                if drawing is None:
                    raise
            finally:
                manager.progress_end()

    def _tell(self, done, warnings):
        """Reports the sentence and all warnings at once: of several reports the status bar shows only the
        last. The redo panel keeps the warnings."""
        self.warned = "\n".join(warnings)
        self.report({"WARNING"} if warnings else {"INFO"}, " ".join([done, *warnings]))

    def invoke(self, context, _event):
        """Executes; warnings to be read first are also shown in a menu at the mouse pointer."""
        self._first_of_all, self._is_invoked = [], not bpy.app.background
        outcome = self.execute(context)
        lines = self._first_of_all
        if lines and self._is_invoked:
            context.window_manager.popup_menu(
                lambda popup, _: wrapped.draw(popup.layout, lines, 80), title="Talweg", icon="ERROR")
        return outcome

    def draw(self, _context):
        layout = self.layout
        wrapped.draw(layout, self.warned.splitlines())
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(self, "output")
        parameters.draw(layout, self)
        wrapped.draw(layout, self.scaled.splitlines(), icon="INFO")
        if self.output == "CURVE":
            settings.draw_own(layout, self)
        for name in _STROKES:
            if hasattr(self, name):
                layout.prop(self, name)


def _without(drawing, sentence):
    """The drawing without the stroke that the error names, and a warning about it. None if the error names no
    stroke, or the only one."""
    at = [k for k, name in enumerate(drawing.names) if sentence.startswith(name + ": ")]
    if not at or len(drawing.curves) < 2:
        return None
    k = at[0]
    return drawing._replace(curves=drawing.curves[:k] + drawing.curves[k + 1:],
                            names=drawing.names[:k] + drawing.names[k + 1:],
                            warnings=[*drawing.warnings, f"Left out: {sentence}"])


def _is_measured(warning, drawing):
    """Whether the library's warning repeats the drawing's own about the distance from the mesh."""
    return bool(drawing.names) and "moved onto the mesh" in warning


_COMMON = {
    "output": outcomes.OUTPUT,
    **settings.own(None),
    "warned": bpy.props.StringProperty(options={"HIDDEN", "SKIP_SAVE"}),
    "scaled": bpy.props.StringProperty(options={"HIDDEN", "SKIP_SAVE"}),
    "mean_edge": bpy.props.FloatProperty(options={"HIDDEN", "SKIP_SAVE"}),
}


_STROKES = {
    "strokes": bpy.props.StringProperty(
        name="Strokes", default="",
        description="Numbers of the strokes to smooth, such as 0, 2-4; -1 is the last; empty: all"),
}


def _edited(context):
    """The objects in edit mode, the active one first. Objects that share a mesh count once."""
    found = [context.object, *(one for one in context.view_layer.objects
                               if one.mode == "EDIT" and one.type == "MESH" and one != context.object)]
    return list({one.data: one for one in reversed(found)}.values())[::-1]


class TALWEG_OT_smooth_edges(_Smoothing, bpy.types.Operator):
    """Smooth the selected edges as curves on the surface, close to where they are"""

    bl_idname = "talweg.smooth_edges"
    bl_label = "Smooth Curve on Surface"

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.mode == "EDIT" \
            and context.object.type == "MESH"

    def execute(self, context):
        edited = _edited(context)
        for obj in edited:
            obj.update_from_editmode()
        chosen = [obj for obj in edited if obj.data.total_edge_sel] or edited[:1]
        return self.smooth(context, chosen, lambda obj, _: drawings.selected_edges(obj.data), False)


class _OnActive(_Smoothing):
    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.mode == "OBJECT" \
            and context.object.type == "MESH"

    def execute(self, context):
        return self.smooth(context, [context.object], lambda obj, place: strokes.drawing_of(
            self.items(context, obj), place, self.strokes),
            self.output == "CURVE")


class TALWEG_OT_smooth_annotations(_OnActive, bpy.types.Operator):
    """Smooth the strokes of the active annotation layer on the active mesh"""

    bl_idname = "talweg.smooth_annotations"
    bl_label = "Smooth Annotations"
    items = staticmethod(strokes.annotations)


class TALWEG_OT_smooth_objects(_OnActive, bpy.types.Operator):
    """Smooth selected curve objects and grease pencil on the active mesh; Bezier points are way-points"""

    bl_idname = "talweg.smooth_objects"
    bl_label = "Smooth Selected Curves"
    items = staticmethod(strokes.objects)


CLASSES = (TALWEG_OT_smooth_edges, TALWEG_OT_smooth_annotations, TALWEG_OT_smooth_objects)


def register():
    for cls in CLASSES:
        cls.__annotations__ = {**parameters.annotations(), **_COMMON}
    for cls in CLASSES[1:]:
        cls.__annotations__.update(_STROKES)
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
