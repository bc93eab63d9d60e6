"""Which objects may be changed, and which others share their mesh."""

import bpy

from .package import talweg


def check(obj):
    """Refuses a mesh that must not be replaced.

    :raises talweg.Unsupported: if the mesh of the object cannot be replaced.
    """
    mesh = obj.data
    if mesh.library is not None:
        raise talweg.Unsupported(f"The mesh {mesh.name} is linked from a library and cannot be changed; "
                                 "make it local first (Object > Relations > Make Local).")
    if not obj.visible_get():
        raise talweg.BadUsage(f"{obj.name} is hidden; show it first (Alt H).")
    if any(modifier.type == "MULTIRES" for modifier in obj.modifiers):
        raise talweg.Unsupported(f"{obj.name} has a Multiresolution modifier, whose sculpted details would "
                                 "be lost; apply it first.")


def others_with_mesh(obj):
    """The other objects that show the same mesh."""
    return [one for one in bpy.data.objects if one is not obj and one.data == obj.data]


def warnings(obj, lost):
    """Warnings about a change of the mesh of this object.

    :param lost: names of the data that the changed mesh does not have.
    """
    others = others_with_mesh(obj)
    verb = "shows" if len(others) == 1 else "show"
    found = [f"{_listed(others)} {verb} the same mesh and changed, too."] if others else []
    return found + ([f"The changed mesh could not keep {', '.join(lost)}; Ctrl Z brings it back."] if lost else [])


def _listed(objects):
    names = [one.name for one in objects]
    return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
