"""Where the operators are found: the sidebar, the Edge menu, the Object menu."""

import bpy

from . import operators, operators_of_meshes, surface

EDGES = operators.TALWEG_OT_smooth_edges.bl_idname
ANNOTATIONS = operators.TALWEG_OT_smooth_annotations.bl_idname
OF_CURVES = [operator.bl_idname for operator in operators_of_meshes.CLASSES[:2]]
OF_MESHES = [operator.bl_idname for operator in operators_of_meshes.CLASSES[2:]]


class VIEW3D_PT_talweg(bpy.types.Panel):
    bl_label = "Talweg"
    bl_category = "Talweg"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, context):
        layout = self.layout
        obj = context.object
        if obj is None or obj.type != "MESH":
            layout.label(text="Choose a mesh")
        elif obj.mode == "EDIT":
            layout.label(text="Select edges, then:")
            layout.operator(EDGES)
            if surface.is_changed(obj):
                layout.label(text="Without modifiers" if obj.modifiers else "Without shape keys",
                             icon="ERROR")
        else:
            layout.label(text="Annotate the surface, then:")
            layout.operator(ANNOTATIONS)
            layout.label(text="Select a curve, then this:")
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
    self.layout.operator(ANNOTATIONS)
    for operator in (*OF_CURVES, *OF_MESHES):
        self.layout.operator(operator)


def register():
    bpy.utils.register_class(VIEW3D_PT_talweg)
    bpy.types.VIEW3D_MT_edit_mesh_edges.append(_edge_menu)
    bpy.types.VIEW3D_MT_object.append(_object_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(_object_menu)
    bpy.types.VIEW3D_MT_edit_mesh_edges.remove(_edge_menu)
    bpy.utils.unregister_class(VIEW3D_PT_talweg)
