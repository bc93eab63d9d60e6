"""Entries for the operators in the sidebar, the Edge menu and the Object menu."""

import bpy

from . import last_report, offsetting, operators, operators_of_meshes, page, repair_offers, resmoothing, session
from . import settings
from .drawing_tool import tool

EDGES = operators.TALWEG_OT_smooth_edges.bl_idname
OF_DRAWINGS = [operator.bl_idname for operator in operators.CLASSES[1:]]
OF_CURVES = [operator.bl_idname for operator in operators_of_meshes.CLASSES[:2]]
OF_MESHES = [operator.bl_idname for operator in operators_of_meshes.CLASSES[2:]]
DRAW = tool.TALWEG_OT_draw.bl_idname
OFFSET = offsetting.TALWEG_OT_offset.bl_idname
INTO_MESH = resmoothing.TALWEG_OT_to_mesh.bl_idname


class VIEW3D_PT_talweg(bpy.types.Panel):
    bl_label = "Talweg"
    bl_category = "Talweg"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw_header_preset(self, _context):
        self.layout.operator(page.TALWEG_OT_page.bl_idname, text="", icon="HELP", emboss=False)

    def draw(self, context):
        obj = context.object
        repair_offers.draw(self.layout, obj)
        reported = obj if settings.is_kept(obj) else _last_curve(context)
        if reported is not None:
            resmoothing.draw_decisive(self.layout, reported)
        if settings.is_kept(obj):
            _of_curve(self.layout, obj)
        elif obj is None or obj.type != "MESH":
            self.layout.label(text="Choose a mesh, or a curve of Talweg")
        elif obj.mode == "EDIT":
            _of_edges(self.layout, obj)
        else:
            _of_mesh(self.layout, obj)
        last_report.draw(self.layout, obj.parent if settings.is_kept(obj) else obj)


class VIEW3D_PT_talweg_curve(bpy.types.Panel):
    """In edit mode, the newest curve of the edited mesh. A change of its values makes no undo step of the
    mesh."""

    bl_label = "Last Curve"
    bl_category = "Talweg"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    @classmethod
    def poll(cls, context):
        return _last_curve(context) is not None

    def draw(self, context):
        curve = _last_curve(context)
        self.layout.label(text=curve.name, icon=resmoothing.icon(curve))
        resmoothing.draw(self.layout, curve)


def _last_curve(context):
    obj = context.object
    if obj is None or obj.type != "MESH":
        return None
    curves = [one for one in obj.children if settings.is_kept(one) and one.visible_get()]
    return max(curves, key=lambda one: one.get("talweg_number", 0), default=None)


def _of_curve(layout, curve):
    if curve.mode == "OBJECT":
        layout.operator(DRAW, text="Edit Curve", icon="GREASEPENCIL")
    resmoothing.draw(layout, curve)
    if curve.mode == "OBJECT":
        layout.operator(OFFSET)
        layout.operator_menu_enum(INTO_MESH, "output")


def _of_edges(layout, obj):
    layout.label(text="Select edges, then:")
    layout.operator(EDGES)
    _say_without(layout, obj, "")


def _say_without(layout, obj, what):
    """A note that an operation works on the mesh without its modifiers or shape keys, if it has any."""
    if session.is_changed(obj):
        without = "without modifiers" if obj.modifiers else "without shape keys"
        layout.label(text=f"{what} {without}".strip().capitalize(), icon="ERROR")


def _of_mesh(layout, obj):
    layout.operator(DRAW, icon="GREASEPENCIL")
    layout.label(text="Annotate the surface, then:")
    layout.operator(OF_DRAWINGS[0])
    layout.label(text="Select a curve, then this:")
    for operator in (*OF_DRAWINGS[1:], OFFSET):
        layout.operator(operator)
    _say_without(layout, obj, "Cuts are")
    for operator in OF_CURVES:
        layout.operator(operator)
    layout.label(text="All of the mesh:")
    for operator in OF_MESHES:
        layout.operator(operator)


def _edge_menu(self, _context):
    self.layout.separator()
    self.layout.operator(EDGES)


def _object_menu(self, _context):
    self.layout.separator()
    for operator in (*OF_DRAWINGS, OFFSET, *OF_CURVES, *OF_MESHES):
        self.layout.operator(operator)


CLASSES = (VIEW3D_PT_talweg, VIEW3D_PT_talweg_curve)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_edit_mesh_edges.append(_edge_menu)
    bpy.types.VIEW3D_MT_object.append(_object_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(_object_menu)
    bpy.types.VIEW3D_MT_edit_mesh_edges.remove(_edge_menu)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
