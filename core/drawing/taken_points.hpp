// The points of a drawing are taken as it says, or as somebody says instead.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/way_point.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

enum class PointMeaning {
  kGiven,  ///< as the drawing says; what it says nothing of is a stroke
  kExact,  ///< a curve that names no way-points has all its points for them, but those painted
  kRough,  ///< everything is a stroke
};

struct PointsTaken {
  PointMeaning meaning = PointMeaning::kGiven;
  std::vector<SurfacePoint> exact;  ///< if there are any, these are the way-points and no others
  double tolerance = 0;             ///< mesh units: of way-points whose own is 0
};

/// Points of the drawn curves.
struct TakenPoints {
  std::vector<WayPoint> way_points;
  std::vector<SurfacePoint> painted;

  bool operator==(const TakenPoints&) const = default;
};
/// O(points).
TakenPoints take_points(const SnappedDrawing& drawing, const PointsTaken& taken);
/// The points of a curve that have marks (point_marks.hpp), one for each or none, and back: of
/// curves that say something of their points. O(points).
TakenPoints points_marked(const SurfaceCurve& curve, std::span<const double> marks);
std::vector<double> marks_of_points(const SurfaceCurve& curve, const TakenPoints& points);
/// Sentences on control points that were taken as a stroke.
std::vector<std::string> stroke_warnings(const SnappedDrawing& drawing, const PointsTaken& taken);

/// Whether the curves have nothing but legs (DrawnLegs). A run of legs_of() for each curve, up to
/// the first that has a stroke.
bool only_way_points(std::span<const SurfaceCurve> curves, const TakenPoints& points);

}  // namespace talweg
