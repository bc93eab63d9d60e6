// Loop closing makes a loop of a stroke whose hand meant one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// What the two ends of a drawn curve are.
enum class CurveEnds {
  kAsDrawn,  ///< a loop where the hand came back to its beginning, or nearly so, or beyond
  kClosed,   ///< always a loop
  kOpen,     ///< never a loop, unless the curve says that it is one
};
/// Of "auto", "closed" and "open". Throws Error(kBadUsage) for others.
CurveEnds curve_ends(std::string_view name);

struct ClosedLoop {
  SurfaceCurve curve;
  double gap = 0;  ///< mesh units, through space: between the points that were joined
  double cut = 0;  ///< mesh units: of what was cut off at both ends
};

/// The loop that an open stroke is meant to be; none if it is none. Its ends run over its
/// beginning, or stop short of it, by no more than what nobody can see: twice its slack
/// (stroke_slack.hpp), an edge of the mesh, or one and a half times the distance of its samples,
/// whichever is most, but no more than a twelfth of its length; and it goes on in about the
/// direction in which it began (75 degrees). What runs over, up to a sixth of the length at either
/// end, is cut off. With `always` it is a loop in any case. O(points), and the pairs of points near
/// both ends.
std::optional<ClosedLoop> closed_loop(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                      StraightLines& lines, bool always = false);

/// How far the ends of an open stroke lie apart, mesh units through space, where that is no more
/// than a twelfth of its length and a loop through them would go on in about the same direction: it
/// may be meant as a loop, though closed_loop() is not sure. O(points).
std::optional<double> gap_of_near_loop(const SurfaceMesh& mesh, const SurfaceCurve& stroke);

}  // namespace talweg
