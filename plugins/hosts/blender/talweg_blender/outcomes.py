"""Puts a smoothed drawing into the scene: as a curve object, as edges of the mesh, or as objects of the
pieces."""

import bpy

from . import curve_object, cutting, jobs
from .package import talweg

ITEMS = [("CURVE", "Curve object", "A curve object on the surface, which can be changed later"),
         ("EDGES", "Edges", "Cut into the mesh as selected edges"),
         ("SEAM", "Seam", "Cut into the mesh and marked as a seam"),
         ("SHARP", "Sharp edges", "Cut into the mesh and marked as sharp"),
         ("OPEN", "Open cut", "Cut into the mesh; either side gets vertices of its own"),
         ("SEPARATE", "Objects", "The mesh is taken apart: an object for each piece")]

OUTPUT = bpy.props.EnumProperty(name="Result", default="CURVE", items=ITEMS)


def check(output, repair):
    """Refuses to cut a mesh by a curve on its repaired copy.

    :raises talweg.BadUsage: if the output needs a cut of a mesh that is not a surface.
    """
    if repair and output != "CURVE":
        raise talweg.BadUsage("On a repaired copy only curve objects can be made; to cut the mesh, use "
                              "Repair for Talweg first.")


def make(context, obj, place, drawing, result, operator, as_shown):
    """Makes the output that the operator asks for. Returns a sentence, and warnings."""
    if operator.output == "CURVE":
        made = curve_object.put(context, obj, place, drawing, result, operator, as_shown)
        return f"Curve: {made.name}.", []
    return jobs.now(of_mesh(context, obj, place, result, operator.output))


def of_mesh(context, obj, place, result, output):
    """Makes an output that changes the mesh. Steps as in jobs.py; they return a sentence, and warnings. The
    result must lie on the mesh without modifiers."""
    if output == "SEPARATE":
        pieces, warnings = yield from cutting.separate(obj, place.arrays, result.curves)
        return f"Objects: {', '.join(one.name for one in pieces)}.", warnings
    mark = {"SEAM": "use_seam", "SHARP": "use_edge_sharp"}.get(output)
    how = {"open": True} if output == "OPEN" else {}
    warnings = (yield from cutting.cut(obj, place.arrays, result.curves, mark=mark, **how))[1]
    context.tool_settings.mesh_select_mode = (False, True, False)
    return "", warnings
