#include "talweg/core/smoothing/missed_points.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/space/message_numbers.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

constexpr double kLeastMiss = 1e-6;  // mean edges: nearer than any two intended points

/// Way-points, and pins and corners as way-points without a tolerance.
std::vector<WayPoint> points_to_pass(const CurveOptions& options) {
  std::vector<WayPoint> points = options.way_points;
  for (const auto* exact : {&options.pins, &options.corners}) {
    for (const SurfacePoint& point : *exact) points.push_back({point});
  }
  return points;
}

struct Missed {
  std::size_t points = 0;
  double farthest = 0;  ///< mesh units, through space
  Point at = Point::Zero();
};

Missed missed_by(const SurfaceMesh& mesh, DeviationMeter& meter, const SurfaceCurve& drawn,
                 const SurfaceCurve& result, const std::vector<WayPoint>& to_pass) {
  const PointLookup on_drawn(drawn.points), on_result(result.points);
  std::vector<SurfacePoint> points;  // points to pass that are not points of the result
  std::vector<double> limits;
  for (const WayPoint& way : to_pass) {
    if (!on_drawn.contains(way.point) || on_result.contains(way.point)) continue;
    points.push_back(way.point);
    limits.push_back(way.tolerance + kLeastMiss * mesh.mean_edge_length());
  }
  Missed missed;
  if (points.empty()) return missed;
  const std::vector<bool> passed = meter.are_near(points, limits, result);
  // Misses are measured in space: exact distances of far points would take too long.
  const NearestSegment nearest(segments_of(positions_of(mesh, result), result.closed));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (passed[i]) continue;
    ++missed.points;
    const Point at = mesh.position(points[i]);
    const double distance = nearest.to(at).distance;
    if (distance <= missed.farthest) continue;
    missed.farthest = distance;
    missed.at = at;
  }
  return missed;
}

}  // namespace

void warn_of_missed_points(const SurfaceMesh& mesh, DeviationMeter& meter,
                           std::span<const SurfaceCurve> drawn, const CurveOptions& options,
                           SmoothingResult& result) {
  const std::vector<WayPoint> points = points_to_pass(options);
  for (std::size_t c = 0; !points.empty() && c < drawn.size(); ++c) {
    const Missed missed = missed_by(mesh, meter, drawn[c], result.curves[c], points);
    if (missed.points == 0) continue;
    const Point& at = missed.at;
    SmoothingReport& report = result.reports[c];
    report.termination = std::max(report.termination, Outcome::kMissed);
    report.missed_points = missed.points;
    report.missed_max = missed.farthest;
    report.missed_at = at;
    std::string sentence = fmt::format(
        "The result misses {} of the points that it should pass, by up to {} through space, "
        "at {}: where a drawing meets itself, small loops and parts that run back along the "
        "drawing are lost.",
        missed.points, mesh_units_text(missed.farthest),
        position_text(at, report.edge_length_near));
    warn_decisively(report, {std::move(sentence), at});
  }
}

}  // namespace talweg
