// The slack of a stroke says how exact it is.
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
  /// In the middle of each of several parts of equal length of the curve, mesh units; empty where
  /// it is the same all along. Linear in between.
  std::vector<double> along;
};

/// The slack at each point of a curve, by the part of its length that lies before it. Empty where
/// it is the same all along. O(points).
std::vector<double> slack_at_points(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                                    const StrokeSlack& slack);

/// The slack of a curve whose points are put in this order, and the reverse. O(points).
StrokeSlack in_order(const StrokeSlack& slack, const SurfaceMesh& mesh, const SurfaceCurve& curve,
                     const CurveOrder& order);
StrokeSlack turned_back(const StrokeSlack& slack, const SurfaceMesh& mesh,
                        const SurfaceCurve& curve, const CurveOrder& order);

/// How exact the strokes of one curve are: the width of their trembling (hand_trembling.hpp), of
/// which the longest stroke decides, without its rests. It is at least a tenth of `edge` (the
/// length of the mesh's edges near the curve, mesh units) and a 240th of the stroke's length,
/// whichever is less, and at most a 24th of that length. Strokes along edges of the mesh, and those
/// in which nothing stands still, have the slack of their segments, and at most that of segments of
/// eight edges. What hand_trembling() costs. Throws Error(kBadCurve) as turning_angle() does.
StrokeSlack stroke_slack(const SurfaceMesh& mesh, std::span<const SurfaceCurve> strokes,
                         double edge);

/// Seven tenths of the median length of a curve's segments, and at most 1/24 of its length.
/// Segments that together turn by less than 0.1 rad are merged first. Segments that end in a turn
/// below 0.2 rad, or have turned little by little, count less. Mesh units. O(points). Throws as
/// turning_angle() does.
double slack_of_segments(const Surface& surface, const SurfaceCurve& curve);

}  // namespace talweg
