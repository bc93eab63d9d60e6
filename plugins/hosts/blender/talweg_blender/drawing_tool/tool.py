"""The tool in Blender's window: its events, its icon, and how it ends."""

from pathlib import Path

import bpy
import numpy as np

from .. import outcomes, repair_offers, session, settings
from ..package import talweg
from .drawn import Drawn
from .overlay import Overlay
from .view import View

_ICON = Path(__file__).parent / "talweg.draw"
_KEYS = ("Drag: draw | Click: way-point, on the curve a pin | Drag a point: move | P: pin | X: remove | C: close "
         "| N: next line | Ctrl Wheel: tau | Ctrl Z: undo | Enter: done | Esc: drop")
_NAVIGATION = ("MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "WHEELINMOUSE", "WHEELOUTMOUSE", "TRACKPADPAN",
               "TRACKPADZOOM", "MOUSEROTATE", "MOUSESMARTZOOM", "HOME")

#: The running operator; at most one.
_now = []


def is_at_work():
    return bool(_now)


def _view_of(context, region, space, obj):
    matrix = np.array(space.region_3d.perspective_matrix) @ np.array(obj.matrix_world)
    return View(matrix, region.width, region.height)


class TALWEG_OT_draw(bpy.types.Operator):
    """Draw on the active mesh and see the smoothed curve at once; if a curve object is active, edit its drawing"""

    bl_idname = "talweg.draw"
    bl_label = "Draw Curve on Surface"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        obj = context.object
        return (not _now and obj is not None and obj.mode == "OBJECT" and context.area is not None
                and context.area.type == "VIEW_3D" and (obj.type == "MESH" or settings.is_kept(obj)))

    def invoke(self, context, event):
        self._refused = None
        active = context.object
        curve = active if settings.is_kept(active) else None
        obj = active.parent if curve else active
        try:
            self._drawn = Drawn(context, obj, curve, "CURVE" if curve else self.output, self.repair)
        except (talweg.Error, KeyboardInterrupt) as error:
            return self._refuse(context, obj, error, event)
        repair_offers.forget(obj)
        self._area, self._ended = context.area, False
        self._region = next(one for one in context.area.regions if one.type == "WINDOW")
        if self._begins_beside(event):
            self._drawn.drop()
            return {"CANCELLED", "PASS_THROUGH"}  # Blender's own click then selects an object
        self._overlay = Overlay(self._shown)
        self._timer = context.window_manager.event_timer_add(1 / 30, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set(_KEYS)
        _now.append(self)
        self._tell()
        return {"RUNNING_MODAL"}

    def _begins_beside(self, event):
        """Uses the press that started the tool as the first press of the drawing. Returns whether the press
        missed the mesh."""
        return event.type == "LEFTMOUSE" and event.value == "PRESS" \
            and not self._drawn.work.press(self._view(), self._at(event), event.shift)

    def _refuse(self, context, obj, error, event):
        if isinstance(error, talweg.BadMesh):
            error = repair_offers.note(obj, session.surface_of(context, obj, True, trust=True), error, self.bl_idname)
        if not repair_offers.is_for(obj):
            self.report({"ERROR"}, str(error) or "Interrupted.")
            return {"CANCELLED"}
        self.report({"WARNING"}, str(error))
        if event.type != "LEFTMOUSE":
            repair_offers.popup(context, obj)
            return {"CANCELLED"}
        self._refused = obj  # a menu that opens under a pressed button would take the release as its click
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    # ---- Events.

    def modal(self, context, event):
        if self._refused is not None:
            if event.type == "LEFTMOUSE" and event.value == "RELEASE":
                repair_offers.popup(context, self._refused)
                return {"CANCELLED"}
            return {"RUNNING_MODAL"}
        if not self._drawn.is_there:
            return self._end(context, self._drawn.drop, {"CANCELLED"})
        if self._area not in list(context.screen.areas):  # another workspace: the drawing is kept
            return self._finish(context, else_drop=True)
        if event.type == "TIMER":
            if self._drawn.poll():
                self._tell()
            return {"PASS_THROUGH"}
        if event.type == "LEFTMOUSE" and event.value == "RELEASE" or self._drawn.work.hand is not None:
            return self._mouse(event)
        if not self._is_inside(event):
            return {"PASS_THROUGH"}
        if event.type in _NAVIGATION and not event.ctrl or event.type.startswith(("NUMPAD_", "NDOF")) \
                and event.type != "NUMPAD_ENTER" or event.alt:
            return {"PASS_THROUGH"}
        if event.type in ("LEFTMOUSE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE"):
            return self._mouse(event)
        if event.type in ("RET", "NUMPAD_ENTER") and event.value == "PRESS":
            return self._finish(context)
        if event.type == "ESC" and event.value == "PRESS":
            return self._end(context, self._drawn.drop, {"CANCELLED"})
        if self._key(event):
            self._tell()
        return {"RUNNING_MODAL"}

    def _mouse(self, event):
        work = self._drawn.work
        view, mouse = self._view(), self._at(event)
        if event.type == "LEFTMOUSE" and event.value == "PRESS":
            if not work.press(view, mouse, event.shift):
                return {"PASS_THROUGH"}  # beside the mesh: Blender turns the view
        elif event.type == "LEFTMOUSE" and event.value == "DOUBLE_CLICK":
            work.double_click(view, mouse)
        elif event.type == "LEFTMOUSE" and event.value == "RELEASE":
            work.release(view, mouse)
        elif event.type == "ESC" and event.value == "PRESS":
            work.drop_hand()
        elif "MOUSEMOVE" in event.type:
            under = work.under
            if not work.move(view, mouse) and work.under == under:
                return {"RUNNING_MODAL"}  # no redraw is needed
        self._tell()
        return {"RUNNING_MODAL"}

    def _key(self, event):
        """Does the command of a key. Returns whether the tool has one for it."""
        work = self._drawn.work
        if event.ctrl and event.type in ("WHEELUPMOUSE", "WHEELDOWNMOUSE"):
            work.turn(1 if event.type == "WHEELUPMOUSE" else -1)
            return True
        if event.value != "PRESS":
            return False
        view, mouse = self._view(), self._at(event)
        if event.type == "Z" and event.ctrl:
            (work.redo if event.shift else work.undo)()
        elif event.type == "P":
            work.pin(view, mouse)
        elif event.type in ("X", "DEL", "BACK_SPACE"):
            work.remove(view, mouse)
        elif event.type == "C":
            work.close()
        elif event.type == "N":
            work.next_line()
        else:
            return False
        return True

    def _at(self, event):
        return np.array([event.mouse_x - self._region.x, event.mouse_y - self._region.y], float)

    def _is_inside(self, event):
        """Whether the mouse is in the view and not over a panel in front of the view."""
        for region in self._area.regions:
            inside = (region.x <= event.mouse_x < region.x + region.width
                      and region.y <= event.mouse_y < region.y + region.height)
            if inside and region.type != "WINDOW" and region.width > 1 and region.height > 1:
                return False
            if region.type == "WINDOW" and not inside:
                return False
        return True

    # ---- What is seen.

    def _view(self):
        return _view_of(bpy.context, self._region, self._area.spaces.active, self._drawn.object)

    def _shown(self, context):
        if self._ended or context.area != self._area or not self._drawn.is_there:
            return None
        return self._drawn.work, self._view()

    def _tell(self):
        drawn = self._drawn
        tau = drawn.work.editor.state.tau
        message = drawn.error or f"{drawn.decisive} {drawn.summary}".strip() or "Click way-points, or draw on the surface."
        waits = "   ..." if drawn.live.is_busy else ""
        self._area.header_text_set(f"Talweg   tau {tau:.3g}   {message}{waits}")
        self._area.tag_redraw()

    # ---- The end.

    def _finish(self, context, else_drop=False):
        try:
            message, warnings = self._drawn.finish(context)
        except (talweg.Error, KeyboardInterrupt) as error:
            if else_drop:
                return self._end(context, self._drawn.drop, {"CANCELLED"})
            self.report({"ERROR"}, str(error) or "Interrupted.")
            return {"RUNNING_MODAL"}
        self.report({"WARNING"} if warnings else {"INFO"}, " ".join([message, *warnings]))
        return self._end(context, lambda: None, {"FINISHED"})

    def _end(self, context, last, outcome):
        self._ended = True
        self._overlay.remove()
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)
        if self in _now:
            _now.remove(self)
        last()
        if any(self._area in list(screen.areas) for screen in bpy.data.screens):  # the area may be closed
            self._area.header_text_set(None)
            self._area.tag_redraw()
        return outcome

    def cancel(self, context):
        """Blender calls cancel() at its end and before it loads another file."""
        if self._refused is None:
            self._end(context, self._drawn.close, None)

    def abandon(self):
        """Ends the tool when the add-on is switched off."""
        self._ended = True
        self._overlay.remove()
        self._drawn.close()
        _now.remove(self)


class DrawTool(bpy.types.WorkSpaceTool):
    """The tool in the toolbar of object mode."""

    bl_space_type = "VIEW_3D"
    bl_context_mode = "OBJECT"
    bl_idname = "talweg.draw_tool"
    bl_label = "Talweg"
    bl_description = "Draw on the surface of the active mesh; the curve is smoothed while you draw"
    bl_icon = str(_ICON)
    bl_keymap = (("talweg.draw", {"type": "LEFTMOUSE", "value": "PRESS"}, None),)

    def draw_settings(_context, layout, tool):
        obj = bpy.context.object
        if obj is None or obj.type != "MESH" and not settings.is_kept(obj):
            layout.label(text="Choose a mesh, or a curve of Talweg", icon="INFO")
        properties = tool.operator_properties("talweg.draw")
        layout.prop(properties, "output")


def register():
    TALWEG_OT_draw.__annotations__ = {
        "output": outcomes.OUTPUT, "repair": settings.own(None)["repair"]}
    bpy.utils.register_class(TALWEG_OT_draw)
    if not bpy.app.background:
        bpy.utils.register_tool(DrawTool, separator=True)


def unregister():
    for one in list(_now):
        one.abandon()
    if not bpy.app.background:
        bpy.utils.unregister_tool(DrawTool)
    bpy.utils.unregister_class(TALWEG_OT_draw)
