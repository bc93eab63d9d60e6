#include "talweg/core/smoothing/missed_points.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

constexpr double kRounding = 1e-6;  // mean edges: no point that was meant is nearer to another

/// Pins and corners are passed exactly, as way-points without a tolerance are.
std::vector<WayPoint> points_to_pass(const CurveOptions& options) {
  std::vector<WayPoint> points = options.way_points;
  for (const auto* exact : {&options.pins, &options.corners}) {
    for (const SurfacePoint& point : *exact) points.push_back({point});
  }
  return points;
}

struct Missed {
  std::size_t points = 0;
  double farthest = 0;  ///< mesh units
  Point at = Point::Zero();
};

Missed missed_by(const SurfaceMesh& mesh, const SurfaceCurve& drawn, const SurfaceCurve& result,
                 const std::vector<WayPoint>& points) {
  const auto is_on = [](const SurfaceCurve& curve, const SurfacePoint& point) {
    return std::ranges::find(curve.points, point) != curve.points.end();
  };
  Missed missed;
  std::optional<PolylineDistance> distance;
  for (const WayPoint& way : points) {
    if (!is_on(drawn, way.point) || is_on(result, way.point)) continue;
    if (!distance) distance.emplace(mesh.surface()).set(std::span(&result, 1));
    const double away = distance->at(way.point).distance;
    if (away <= way.tolerance + kRounding * mesh.mean_edge_length()) continue;
    ++missed.points;
    if (away <= missed.farthest) continue;
    missed.farthest = away;
    missed.at = mesh.position(way.point);
  }
  return missed;
}

}  // namespace

void warn_of_missed_points(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                           const CurveOptions& options, SmoothingResult& result) {
  const std::vector<WayPoint> points = points_to_pass(options);
  for (std::size_t c = 0; !points.empty() && c < drawn.size(); ++c) {
    const Missed missed = missed_by(mesh, drawn[c], result.curves[c], points);
    if (missed.points == 0) continue;
    const Point& at = missed.at;
    result.reports[c].warnings.push_back(fmt::format(
        "The result misses {} of the points that it was to pass, by up to {:.3g} at ({:.6g}, "
        "{:.6g}, {:.6g}): the drawing runs back over itself.",
        missed.points, missed.farthest, at.x(), at.y(), at.z()));
  }
}

}  // namespace talweg
