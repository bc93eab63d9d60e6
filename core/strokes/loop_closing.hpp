// Loop closing makes a closed curve of a stroke whose hand meant a loop.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The treatment of the two ends of a drawn curve.
enum class CurveEnds {
  kAsDrawn,  ///< a loop where the hand came back to its beginning, or nearly so, or beyond
  kClosed,   ///< always a loop
  kOpen,     ///< never a loop, unless the input marks the curve as closed
};
/// The value named "auto", "closed" or "open". Throws Error(kBadUsage) for other names.
CurveEnds curve_ends(std::string_view name);

struct ClosedLoop {
  SurfaceCurve curve;
  double gap = 0;  ///< mesh units, through space, between the joined points
  double cut = 0;  ///< mesh units: the length cut off at both ends
};

/// The loop that an open stroke is meant to be; none if the stroke is not meant as a loop. The ends
/// of a loop run over its beginning, or stop short of it, by a gap that is hardly visible: at most
/// twice the stroke's slack (stroke_slack.hpp), an edge of the mesh, or one and a half times the
/// distance of its samples, whichever is most, but no more than a twelfth of its length. The end
/// must also go on in about the direction of the beginning (75 degrees). Parts that run over are
/// cut off, up to a sixth of the length at either end. With `always` the stroke becomes a loop in
/// any case. O(points), and the pairs of points near both ends.
std::optional<ClosedLoop> closed_loop(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                      StraightLines& lines, bool always = false);

/// The distance between the ends of an open stroke, mesh units through space, if a loop is likely
/// but not certain: the distance is at most a twelfth of the stroke's length, and a loop would go
/// on in about the same direction at the ends. O(points).
std::optional<double> gap_of_near_loop(const SurfaceMesh& mesh, const SurfaceCurve& stroke);

}  // namespace talweg
