"""Talweg in Blender: smooths curves on meshes while they stay close to what was drawn.

Edit mode: select edges, Edge > Smooth Curve on Surface. Object mode: draw with the annotation tool
on the surface, Object > Smooth Annotations. These, cutting, borders of materials and
vertex groups, and repair are in the sidebar, tab Talweg.
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

from . import again, marks, offsetting, operators, operators_of_meshes, page, panel, session  # noqa: E402
from . import settings, told  # noqa: E402
from .drawing_tool import tool  # noqa: E402

_PARTS = (session, told, settings, page, operators, operators_of_meshes, offsetting, again, tool,
          marks, panel)


def register():
    for part in _PARTS:
        part.register()


def unregister():
    for part in reversed(_PARTS):
        part.unregister()
