// Border ends are ends of open curves that are led to the border of the mesh, because they stop a
// little before it.
#pragma once

#include <string_view>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// What becomes of ends that lie near the border.
enum class BorderEnds {
  kSnap,   ///< they are led straight to it
  kLeave,  ///< nothing
};
/// Of "snap" and "leave". Throws Error(kBadUsage) for others.
BorderEnds border_ends(std::string_view name);

/// Which curves are looked at.
enum class LedCurves {
  kStrokes,  ///< open strokes of a hand, without way-points
  kAll,      ///< all that are open
};

/// Leads ends straight to the nearest point of the border, and tells which, and how far. "Near" is
/// two edges of the mesh around the end, or one and a half times the distance of a hand's last
/// samples (at most a twelfth of the curve's length), but no more than half the curve's length. An
/// end at which another curve passes stays. The new end is no way-point, but for a drawing all
/// points of which are taken exactly. Throws as StraightLines::join(). O(faces within that distance
/// of each end), and the points of all curves for an end that is led.
SnappedDrawing with_ends_at_border(const SurfaceMesh& mesh, SnappedDrawing drawing,
                                   StraightLines& lines, LedCurves which = LedCurves::kAll);

}  // namespace talweg
