#include "talweg/core/drawing/drawn_legs.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

/// A point of the curve that is a way-point, a pin or an end; `point` is its index in the curve.
struct Mark {
  std::size_t point = 0;
  bool is_way_point = false;
  double tolerance = 0;
};

std::vector<Mark> marks_on(const SurfaceCurve& curve, std::span<const SurfacePoint> pins,
                           std::span<const WayPoint> way_points) {
  std::vector<Mark> marks;
  PointLookup exact_points;
  for (const WayPoint& way_point : way_points) exact_points.add(way_point.point);
  const PointLookup pinned(pins);
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SurfacePoint& point = curve.points[i];
    const std::optional<std::size_t> exact = exact_points.find(point);
    const bool is_way_point = exact.has_value();
    const bool is_end = !curve.closed && (i == 0 || i + 1 == n);
    if (is_way_point || is_end || pinned.contains(point)) {
      marks.push_back({i, is_way_point, is_way_point ? way_points[*exact].tolerance : 0});
    }
  }
  return marks;
}

}  // namespace

bool DrawnLegs::any() const {
  return std::find(is_leg.begin(), is_leg.end(), true) != is_leg.end();
}

bool DrawnLegs::all() const {
  return !is_leg.empty() && std::find(is_leg.begin(), is_leg.end(), false) == is_leg.end();
}

DrawnLegs legs_of(const SurfaceCurve& curve, std::span<const SurfacePoint> pins,
                  std::span<const WayPoint> way_points, std::span<const SurfacePoint> painted) {
  DrawnLegs legs;
  if (way_points.empty()) return legs;
  const std::vector<Mark> marks = marks_on(curve, pins, way_points);
  const std::size_t m = marks.size(), n = curve.points.size();
  const std::size_t stretches = m == 0 ? 0 : curve.closed ? m : m - 1;
  const auto exact = static_cast<std::size_t>(
      std::count_if(marks.begin(), marks.end(), [](const Mark& k) { return k.is_way_point; }));
  const PointLookup by_hand(painted);
  const auto is_painted = [&](std::size_t stretch) {
    const std::size_t to = marks[(stretch + 1) % m].point;
    for (std::size_t i = (marks[stretch].point + 1) % n; i != to; i = (i + 1) % n) {
      if (by_hand.contains(curve.points[i])) return true;
    }
    return false;
  };
  // All stretches between two successive way-points, which pins may divide, are legs if no point of
  // them is painted.
  std::vector<bool> is_leg(stretches, false);
  const bool may = exact >= (curve.closed ? 3U : 2U);
  for (std::size_t k = 0; may && k < m; ++k) {
    if (!marks[k].is_way_point) continue;
    std::vector<std::size_t> own;
    bool stroke = false, ends = false;
    for (std::size_t s = k; !ends && own.size() < stretches && s < (curve.closed ? 2 * m : m - 1);
         ++s) {
      own.push_back(s % m);
      stroke = stroke || is_painted(s % m);
      ends = marks[(s + 1) % m].is_way_point;
    }
    for (const std::size_t s : own) is_leg[s] = ends && !stroke;
  }
  for (const Mark& mark : marks) {
    legs.fixed.push_back(curve.points[mark.point]);
    legs.tolerances.push_back(mark.tolerance);
  }
  legs.is_leg = std::move(is_leg);
  return legs;
}

}  // namespace talweg
