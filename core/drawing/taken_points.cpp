#include "talweg/core/drawing/taken_points.hpp"

#include <algorithm>

namespace talweg {
namespace {

bool passes(const SurfaceCurve& curve, const SurfacePoint& point) {
  return std::find(curve.points.begin(), curve.points.end(), point) != curve.points.end();
}

bool is_free(const SurfaceCurve& curve, std::span<const WayPoint> way_points,
             std::span<const SurfacePoint> painted) {
  const auto is_way_point = [&](const SurfacePoint& point) {
    return std::any_of(way_points.begin(), way_points.end(),
                       [&](const WayPoint& way) { return way.point == point; });
  };
  const bool from_way_point =
      curve.closed ? std::any_of(way_points.begin(), way_points.end(),
                                 [&](const WayPoint& way) { return passes(curve, way.point); })
                   : is_way_point(curve.points.front()) && is_way_point(curve.points.back());
  return from_way_point && std::none_of(painted.begin(), painted.end(),
                                        [&](const auto& point) { return passes(curve, point); });
}

}  // namespace

void take_points(const SnappedDrawing& drawing, const PointsTaken& taken, CurveOptions& options) {
  options.way_points.clear();
  options.painted.clear();
  const bool rough = taken.meaning == PointMeaning::kRough;
  if (!taken.exact.empty()) {
    for (const SurfacePoint& point : taken.exact) options.way_points.push_back({point, 0});
  } else if (!rough) {
    options.way_points =
        taken.meaning == PointMeaning::kExact ? drawing.all_exact : drawing.way_points;
  }
  if (!rough) options.painted = drawing.painted;
  for (WayPoint& way : options.way_points) {
    if (way.tolerance == 0) way.tolerance = taken.tolerance;
  }
}

std::vector<std::string> stroke_warnings(const SnappedDrawing& drawing, const PointsTaken& taken) {
  const bool as_given = taken.meaning == PointMeaning::kGiven && taken.exact.empty();
  return as_given ? drawing.strokes : std::vector<std::string>();
}

bool only_way_points(std::span<const SurfaceCurve> curves, std::span<const WayPoint> way_points,
                     std::span<const SurfacePoint> painted) {
  return !curves.empty() && std::all_of(curves.begin(), curves.end(), [&](const auto& curve) {
    return is_free(curve, way_points, painted);
  });
}

}  // namespace talweg
