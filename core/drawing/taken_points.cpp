#include "talweg/core/drawing/taken_points.hpp"

#include <algorithm>

#include "talweg/core/drawing/drawn_legs.hpp"

namespace talweg {
TakenPoints take_points(const SnappedDrawing& drawing, const PointsTaken& taken) {
  TakenPoints points;
  const bool rough = taken.meaning == PointMeaning::kRough;
  if (!taken.exact.empty()) {
    for (const SurfacePoint& exact : taken.exact) points.way_points.push_back({exact, 0});
  } else if (!rough) {
    points.way_points =
        taken.meaning == PointMeaning::kExact ? drawing.all_exact : drawing.way_points;
  }
  if (!rough) points.painted = drawing.painted;
  for (WayPoint& way : points.way_points) {
    if (way.tolerance == 0) way.tolerance = taken.tolerance;
  }
  return points;
}

std::vector<std::string> stroke_warnings(const SnappedDrawing& drawing, const PointsTaken& taken) {
  const bool as_given = taken.meaning == PointMeaning::kGiven && taken.exact.empty();
  return as_given ? drawing.strokes : std::vector<std::string>();
}

bool only_way_points(std::span<const SurfaceCurve> curves, const TakenPoints& points) {
  return !curves.empty() && std::all_of(curves.begin(), curves.end(), [&](const auto& curve) {
    return legs_of(curve, {}, points.way_points, points.painted).all();
  });
}

}  // namespace talweg
