// Border ends are ends of open curves that stop a little before the mesh's border and are extended
// to it.
#pragma once

#include <string_view>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// The treatment of curve ends that lie near the border.
enum class BorderEnds {
  kSnap,   ///< the ends are extended straight to the border
  kLeave,  ///< the ends stay as drawn
};
/// The value named "snap" or "leave". Throws Error(kBadUsage) for other names.
BorderEnds border_ends(std::string_view name);

/// The curves whose ends are extended.
enum class ExtendedCurves {
  kStrokes,  ///< open strokes of a hand, without way-points
  kAll,      ///< all open curves
};

/// Extends ends straight to the nearest point of the border, and adds a sentence that says which
/// ends were extended, and how far. An end is near the border within two edge lengths of the mesh
/// around it, or one and a half times the distance of a hand's last samples (at most a twelfth of
/// the curve's length), but no more than half the curve's length. An end at which another curve
/// passes stays. The new end is a way-point only under PointMeaning::kExact. Throws as
/// StraightLines::join(). O(faces within that distance of each end), and the points of all curves
/// for each extended end.
SnappedDrawing with_ends_at_border(const SurfaceMesh& mesh, SnappedDrawing drawing,
                                   StraightLines& lines,
                                   ExtendedCurves which = ExtendedCurves::kAll);

}  // namespace talweg
