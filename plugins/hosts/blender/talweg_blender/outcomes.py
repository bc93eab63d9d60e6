"""What becomes of a smoothed drawing: a curve object, edges of the mesh, or objects of its pieces."""

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
    """:raises talweg.BadUsage: if a mesh that is no surface would have to be cut."""
    if repair and output != "CURVE":
        raise talweg.BadUsage("On a repaired copy only curve objects can be made; to cut the mesh, use "
                              "Repair for Talweg first.")


def make(context, obj, place, drawing, result, operator, as_shown):
    """Returns a sentence, and warnings."""
    if operator.output == "CURVE":
        made = curve_object.put(context, obj, place, drawing, result, operator, as_shown)
        return f"Curve: {made.name}.", []
    return jobs.now(of_mesh(context, obj, place, result, operator.output))


def of_mesh(context, obj, place, result, output):
    """The same of all others, as steps of jobs; without modifiers the surface must be the mesh itself."""
    if output == "SEPARATE":
        pieces, warnings = yield from cutting.separate(obj, place.arrays, result.curves)
        return f"Objects: {', '.join(one.name for one in pieces)}.", warnings
    mark = {"SEAM": "use_seam", "SHARP": "use_edge_sharp"}.get(output)
    how = {"open": True} if output == "OPEN" else {}
    warnings = (yield from cutting.cut(obj, place.arrays, result.curves, mark=mark, **how))[1]
    context.tool_settings.mesh_select_mode = (False, True, False)
    return "", warnings
