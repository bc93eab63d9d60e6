"""Cut along curve objects, separate, smooth borders of materials and vertex groups, repair."""

import bpy

from . import cutting, drawings, jobs, offers, session
from .naming import named
from .package import talweg

#: Points of curve objects are of single precision: so near an edge they are on it.
_MERGE = 1e-5


#: Shorter words where the plugin's do not fit into the panel.
_LABELS = {"ends": "Ends"}
_CHOICES = {"fixed": "Stay", "free": "Move", "slide": "Slide", "auto": "Automatic",
            "left": "Left", "right": "Right"}


def _choice(plugin, name):
    parameter = talweg.plugin(plugin).parameters[name]
    return bpy.props.EnumProperty(
        name=_LABELS.get(name, parameter.label), default=parameter.default,
        description=f"{parameter.label}. {parameter.doc}".rstrip("."),
        items=[(id, _CHOICES.get(id, label), label) for id, label in
               zip(parameter.choices, parameter.choice_labels)])


def _number(plugin, name, default, low, high, **more):
    parameter = talweg.plugin(plugin).parameters[name]
    return bpy.props.FloatProperty(name=parameter.label, description=parameter.doc.rstrip("."),
                                   default=default, min=low, soft_max=high, precision=3, step=10, **more)


def _counted(number, word):
    return f"{number} {word}" + ("" if number == 1 else "s")


class _OnMesh:
    """In object mode, on the active mesh."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.mode == "OBJECT" \
            and context.object.type == "MESH"

    def execute(self, context):
        context.object.update_from_editmode()
        return self.reported(lambda: self.work(context, context.object,
                                               drawings.MeshArrays(context.object.data)))

    def reported(self, work):
        """:param work: gives a sentence, and warnings."""
        try:
            told, warnings = work()
        except (talweg.Error, KeyboardInterrupt) as error:
            self.report({"ERROR"}, str(error) or "Interrupted.")
            return {"CANCELLED"}
        # One report: of several the status bar shows only the last.
        self.report({"WARNING"} if warnings else {"INFO"}, " ".join([told, *warnings]))
        return {"FINISHED"}

    def draw(self, _context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        for name in type(self).__annotations__:
            self.layout.prop(self, name)


def _drawing(context, obj):
    """The drawing of curve objects, and what goes with it."""
    place = session.surface_of(context, obj, as_shown=False)
    drawing = drawings.curve_objects(context, obj, place, place.known_curves())
    exact = all(curve.faces is not None for curve in drawing.curves)
    return drawing, {} if exact else {"merge": _MERGE}


def _of_report(made):
    """Without how far curves were moved: the drawing has told it where it mattered."""
    return [one for one in made.report["warnings"] if "moved onto the mesh" not in one]


class TALWEG_OT_cut(_OnMesh, bpy.types.Operator):
    """Make selected curve objects edges of the active mesh; it keeps all that it has"""

    bl_idname = "talweg.cut"
    bl_label = "Cut Along Curve"

    def work(self, context, obj, arrays):
        drawing, how = _drawing(context, obj)
        with named(drawing.names):
            made, warnings = cutting.cut(obj, arrays, drawing.curves, open=self.open, **how)
        context.tool_settings.mesh_select_mode = (False, True, False)
        return (_counted(made.report["cut_faces"], "face") + " cut.",
                [*drawing.warnings, *warnings, *_of_report(made)])


class TALWEG_OT_separate(_OnMesh, bpy.types.Operator):
    """Take the active mesh apart along selected curve objects: an object for each piece"""

    bl_idname = "talweg.separate"
    bl_label = "Separate Along Curve"

    def work(self, context, obj, arrays):
        drawing, how = _drawing(context, obj)
        with named(drawing.names):
            pieces, warnings = cutting.separate(obj, arrays, drawing.curves, keep=self.keep,
                                                cap=self.cap, **how)
        if len(pieces) == 1 and self.keep == "both":
            warnings.append("The curves do not part the mesh; it was only opened along them.")
        return (f"{_counted(len(pieces), 'object')}: {', '.join(one.name for one in pieces)}.",
                [*drawing.warnings, *warnings])


#: Passed on while a job is at work, so that the view can be turned.
_NAVIGATION = ("MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "MOUSEMOVE", "TRACKPADPAN", "TRACKPADZOOM")


class _Borders(_OnMesh):
    """A button begins a job, which Esc ends; what comes soon is there at once. Scripts and the redo panel
    wait."""

    def work(self, _context, obj, arrays):
        return jobs.now(self.steps(obj, arrays))

    def invoke(self, context, _event):
        if bpy.app.background or context.window is None:
            return self.execute(context)
        self._timer = None
        obj = context.object
        try:
            self._steps = self.steps(obj, drawings.MeshArrays(obj.data))
            self._job = jobs.Job(next(self._steps))
        except talweg.Error as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if self._job.is_done(wait=0.3):
            return self._finish(context)
        manager = context.window_manager
        self._timer = manager.event_timer_add(0.1, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"INFO"}, f"{self.bl_label} was stopped; nothing has changed.")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if event.type in _NAVIGATION else {"RUNNING_MODAL"}
        if self._job.is_done():
            return self._finish(context)
        context.workspace.status_text_set(f"{self.bl_label}: {self._job.told}   |   Esc: stop")
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        """Esc, or Blender ends."""
        self._job.stop()
        self._clear(context)

    def _clear(self, context):
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            context.workspace.status_text_set(None)

    def _finish(self, context):
        self._clear(context)
        return self.reported(lambda: jobs.after(self._steps, self._job.given()))

    def smoothed(self):
        how = {"tau": self.tau, "junctions": self.junctions, "ends": self.ends}
        if self.max_deviation > 0:
            how["max_deviation"] = self.max_deviation
        return how

    def told(self, found, warnings):
        return _counted(len(found.borders), "border") + ".", [*warnings, *found.report["warnings"]]


class TALWEG_OT_material_borders(_Borders, bpy.types.Operator):
    """Smooth all borders between materials together, and cut them into the mesh"""

    bl_idname = "talweg.material_borders"
    bl_label = "Smooth Material Borders"

    def steps(self, obj, arrays):
        return self.told(*(yield from cutting.smooth_materials(obj, arrays, **self.smoothed())))


class TALWEG_OT_group_borders(_Borders, bpy.types.Operator):
    """Smooth the border of the active vertex group, and cut it into the mesh"""

    bl_idname = "talweg.group_borders"
    bl_label = "Smooth Vertex-Group Borders"

    def steps(self, obj, arrays):
        return self.told(*(yield from cutting.smooth_group(obj, arrays, self.threshold, **self.smoothed())))


class TALWEG_OT_repair(_OnMesh, bpy.types.Operator):
    """Make a surface of the mesh: weld, drop, orient and split what keeps curves from it"""

    bl_idname = "talweg.repair"
    bl_label = "Repair for Talweg"

    @classmethod
    def poll(cls, context):
        """In edit mode, too, where meshes are refused."""
        return context.object is not None and context.object.mode in ("OBJECT", "EDIT") \
            and context.object.type == "MESH"

    def work(self, _context, obj, arrays):
        steps = ",".join(name for name in ("weld", "drop", "orient", "split") if getattr(self, name))
        if not steps:
            raise talweg.BadUsage("No step of the repair is chosen.")
        fixed, warnings = cutting.repair(obj, arrays, steps)
        offers.forget(obj)
        return " ".join(fixed.changes) or "The mesh needs no repair.", warnings


CLASSES = (TALWEG_OT_cut, TALWEG_OT_separate, TALWEG_OT_material_borders, TALWEG_OT_group_borders,
           TALWEG_OT_repair)


def _properties():
    borders = {"tau": _number("talweg.labels", "tau", 1, 0, 16),
               "max_deviation": _number("talweg.labels", "max_deviation", 0, 0, 1e30, unit="LENGTH"),
               "junctions": _choice("talweg.labels", "junctions"),
               "ends": _choice("talweg.labels", "ends")}
    threshold = bpy.props.FloatProperty(name="Inside from", default=0.5, min=0, max=1, precision=3,
                                        description="Vertices of this weight or more are inside")
    steps = {name: bpy.props.BoolProperty(
        name=name.capitalize(), default=True,
        description=talweg.plugin("talweg.repair").parameters["repair_" + name].doc.rstrip("."))
        for name in ("weld", "drop", "orient", "split")}
    opened = talweg.plugin("talweg.cut").parameters["open"]
    return {TALWEG_OT_cut: {"open": bpy.props.BoolProperty(
                name=opened.label, default=False, description=opened.doc.rstrip("."))},
            TALWEG_OT_separate: {name: _choice("talweg.cut", name) for name in ("keep", "cap")},
            TALWEG_OT_material_borders: borders,
            TALWEG_OT_group_borders: {"threshold": threshold, **borders}, TALWEG_OT_repair: steps}


def register():
    for cls, properties in _properties().items():
        cls.__annotations__ = properties
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
