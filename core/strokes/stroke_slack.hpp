// The slack of a stroke is the distance within which its true course is uncertain.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/drawing/canonical_order.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct StrokeSlack {
  double slack = 0;  ///< mesh units, >= 0
  SlackSource source = SlackSource::kNone;
  /// The slack in the middle of each of several parts of equal length of the curve, mesh units, to
  /// be interpolated linearly. Empty where the slack is the same along the whole curve.
  std::vector<double> along;
};

/// The slack at each point of a curve, interpolated by the part of the curve's length before the
/// point. Empty where the slack is the same along the whole curve. O(points).
std::vector<double> slack_at_points(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                                    const StrokeSlack& slack);

/// in_order() gives the slack of the curve with its points in the given order; turned_back() is the
/// inverse. O(points).
StrokeSlack in_order(const StrokeSlack& slack, const SurfaceMesh& mesh, const SurfaceCurve& curve,
                     const CurveOrder& order);
StrokeSlack turned_back(const StrokeSlack& slack, const SurfaceMesh& mesh,
                        const SurfaceCurve& curve, const CurveOrder& order);

/// The slack of the strokes of one curve: the width of their trembling (hand_trembling.hpp),
/// measured on the longest stroke after its rests are removed. The slack is at least a tenth of
/// `edge` (the length of the mesh's edges near the curve, mesh units) or a 240th of the stroke's
/// length, whichever is less, and at most a 24th of that length. Strokes along edges of the mesh,
/// and strokes without a measurable trembling, have slack_of_segments(), but no more than the slack
/// of segments that are eight mesh edges long. Costs hand_trembling(). Throws Error(kBadCurve) as
/// turning_angle() does.
StrokeSlack stroke_slack(const SurfaceMesh& mesh, std::span<const SurfaceCurve> strokes,
                         double edge);

/// Seven tenths of the median length of a curve's segments, and at most 1/24 of the curve's length,
/// mesh units. Segments that together turn by less than 0.1 rad are merged first. Segments that end
/// in a turn below 0.2 rad, or have turned gradually, count less. O(points). Throws as
/// turning_angle() does.
double slack_of_segments(const Surface& surface, const SurfaceCurve& curve);

}  // namespace talweg
