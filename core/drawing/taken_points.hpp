// Taken points are the way-points and painted points of a drawing after the user's choice of
// meaning.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/way_point.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

enum class PointMeaning {
  kGiven,  ///< as the drawing says; other points are a stroke
  kExact,  ///< in curves without way-points, all points but painted ones are way-points
  kRough,  ///< all points are a stroke
};

struct PointsTaken {
  PointMeaning meaning = PointMeaning::kGiven;
  std::vector<SurfacePoint> exact;  ///< unless empty, the only way-points
  double tolerance = 0;             ///< mesh units: of way-points whose own tolerance is 0
};

/// Points of the drawn curves.
struct TakenPoints {
  std::vector<WayPoint> way_points;
  std::vector<SurfacePoint> painted;

  bool operator==(const TakenPoints&) const = default;
};
/// O(points).
TakenPoints take_points(const SnappedDrawing& drawing, const PointsTaken& taken);
/// The way-points and painted points of a curve from its marks (point_marks.hpp), one for each
/// point or none; and the marks from these points. O(points).
TakenPoints points_marked(const SurfaceCurve& curve, std::span<const double> marks);
std::vector<double> marks_of_points(const SurfaceCurve& curve, const TakenPoints& points);
/// Sentences on control points that were taken as a stroke.
std::vector<std::string> stroke_warnings(const SnappedDrawing& drawing, const PointsTaken& taken);

/// Whether all stretches of the curves are legs (DrawnLegs). Costs legs_of() for each curve up to
/// the first that has a stroke.
bool only_way_points(std::span<const SurfaceCurve> curves, const TakenPoints& points);

}  // namespace talweg
