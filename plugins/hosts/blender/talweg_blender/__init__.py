"""Talweg in Blender: smooths curves on meshes and keeps them close to the drawing.

Edit mode: select edges, Edge > Smooth Curve on Surface. Object mode: draw with the annotation tool on the
surface, Object > Smooth Annotations. The sidebar, tab Talweg, has both commands, and cutting, borders of
materials and vertex groups, and repair.
"""

bl_info = {
    "name": "Talweg: smooth curves on surfaces",
    "author": "The Talweg authors",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "View3D > Sidebar > Talweg; Edge menu; Object menu",
    "description": "Smooth drawn curves on meshes while they stay close to the drawing",
    "category": "Mesh",
}

from . import last_report, marks, offsetting, operators, operators_of_meshes, page, panel  # noqa: E402
from . import resmoothing, session, settings  # noqa: E402
from .drawing_tool import tool  # noqa: E402

_PARTS = (session, last_report, settings, page, operators, operators_of_meshes, offsetting, resmoothing, tool,
          marks, panel)


def register():
    for part in _PARTS:
        part.register()


def unregister():
    for part in reversed(_PARTS):
        part.unregister()
