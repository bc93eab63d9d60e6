// Marked points are the points of a drawing that have a mark (point_marks.hpp): way-points and
// painted points.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/way_point.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The user's choice of the points that are way-points.
enum class PointMeaning {
  kGiven,  ///< as the drawing says; other points are a stroke
  kExact,  ///< in curves without way-points, all points but painted ones are way-points
  kRough,  ///< all points are a stroke
};

/// How the points of a drawing are read.
struct PointOptions {
  PointMeaning meaning = PointMeaning::kGiven;
  std::vector<SurfacePoint> exact;  ///< unless empty, the only way-points
  double tolerance = 0;             ///< mesh units: of way-points whose own tolerance is 0
};

/// Points of the drawn curves.
struct MarkedPoints {
  std::vector<WayPoint> way_points;
  std::vector<SurfacePoint> painted;

  bool operator==(const MarkedPoints&) const = default;
};
/// The marked points of a drawing as the options say. O(points).
MarkedPoints marked_points(const SnappedDrawing& drawing, const PointOptions& options);
/// The way-points and painted points of a curve from its marks (point_marks.hpp), one for each
/// point or none; and the marks from these points. O(points).
MarkedPoints marked_points(const SurfaceCurve& curve, std::span<const double> marks);
std::vector<double> marks_of_points(const SurfaceCurve& curve, const MarkedPoints& points);
/// Sentences on control points that are read as a stroke.
std::vector<std::string> stroke_warnings(const SnappedDrawing& drawing,
                                         const PointOptions& options);

/// Whether all stretches of the curves are legs (DrawnLegs). Costs legs_of() for each curve up to
/// the first that has a stroke.
bool only_way_points(std::span<const SurfaceCurve> curves, const MarkedPoints& points);

}  // namespace talweg
