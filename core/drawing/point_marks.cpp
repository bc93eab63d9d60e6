#include "talweg/core/drawing/point_marks.hpp"

#include <cmath>

namespace talweg {

bool is_mark(double value) {
  return std::isfinite(value) && (value >= 0 || value == kNotSaid || value == kPainted);
}

std::size_t point_count(const CurveInput& curve) {
  return std::visit([](const auto& points) { return points.size(); }, curve.points);
}

std::vector<double> marks_of(const CurveInput& curve) {
  if (curve.way_points.empty() && curve.painted.empty() && !curve.control_points) return {};
  std::vector<double> marks(point_count(curve), curve.control_points ? kControl : kNotSaid);
  for (const std::size_t k : curve.painted) marks.at(k) = kPainted;
  for (const InputWayPoint& way : curve.way_points) marks.at(way.point) = way.tolerance;
  return marks;
}

void set_marks(CurveInput& curve, std::span<const double> marks) {
  curve.way_points.clear();
  curve.painted.clear();
  curve.control_points = false;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (marks[k] >= 0) curve.way_points.push_back({k, marks[k]});
    if (marks[k] == kPainted) curve.painted.push_back(k);
    if (marks[k] == kControl) curve.control_points = true;
  }
}

std::vector<double> marks_through(const SurfaceCurve& drawn, std::span<const SurfacePoint> given,
                                  std::span<const double> given_marks) {
  std::vector<double> marks(drawn.points.size(), kNotSaid);
  std::size_t next = 0;
  for (std::size_t k = 0; k < drawn.points.size(); ++k) {
    // Successive given points at one place are one point of the curve.
    while (next < given.size() && drawn.points[k] == given[next]) {
      const double mark = given_marks.empty() ? 0 : given_marks[next];
      if (marks[k] == kNotSaid || mark >= 0) marks[k] = mark;
      ++next;
    }
  }
  return marks;
}

}  // namespace talweg
