#include "talweg/core/drawing/marked_points.hpp"

#include <algorithm>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
MarkedPoints marked_points(const SnappedDrawing& drawing, const PointOptions& options) {
  MarkedPoints points;
  const bool rough = options.meaning == PointMeaning::kRough;
  if (!options.exact.empty()) {
    for (const SurfacePoint& exact : options.exact) points.way_points.push_back({exact, 0});
  } else if (!rough) {
    points.way_points =
        options.meaning == PointMeaning::kExact ? drawing.all_exact : drawing.way_points;
  }
  if (!rough) points.painted = drawing.painted;
  for (WayPoint& way : points.way_points) {
    if (way.tolerance == 0) way.tolerance = options.tolerance;
  }
  return points;
}

MarkedPoints marked_points(const SurfaceCurve& curve, std::span<const double> marks) {
  MarkedPoints points;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (marks[k] >= 0) points.way_points.push_back({curve.points[k], marks[k]});
    if (marks[k] == kPainted) points.painted.push_back(curve.points[k]);
  }
  return points;
}

std::vector<double> marks_of_points(const SurfaceCurve& curve, const MarkedPoints& points) {
  PointLookup exact;
  for (const WayPoint& way : points.way_points) exact.add(way.point);
  const PointLookup painted(points.painted);
  std::vector<double> marks;
  for (const SurfacePoint& point : curve.points) {
    const auto way = exact.find(point);
    marks.push_back(way                       ? points.way_points[*way].tolerance
                    : painted.contains(point) ? kPainted
                                              : kNotSaid);
  }
  return marks;
}

std::vector<std::string> stroke_warnings(const SnappedDrawing& drawing,
                                         const PointOptions& options) {
  const bool as_given = options.meaning == PointMeaning::kGiven && options.exact.empty();
  return as_given ? drawing.strokes : std::vector<std::string>();
}

bool only_way_points(std::span<const SurfaceCurve> curves, const MarkedPoints& points) {
  return !curves.empty() && std::all_of(curves.begin(), curves.end(), [&](const auto& curve) {
    return legs_of(curve, {}, points.way_points, points.painted).all();
  });
}

}  // namespace talweg
