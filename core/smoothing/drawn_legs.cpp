#include "talweg/core/smoothing/drawn_legs.hpp"

#include <algorithm>
#include <cstddef>

namespace talweg {
namespace {

/// Where the curve passes the fixed points from one place on; empty where it does not. It may pass
/// one of them on its way between two others, too.
std::vector<std::size_t> places_from(std::size_t first, const std::vector<SurfacePoint>& fixed,
                                     const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  std::vector<std::size_t> places;
  for (std::size_t steps = 0; steps < n && places.size() < fixed.size(); ++steps) {
    const std::size_t i = (first + steps) % n;
    if (curve.points[i] == fixed[places.size()]) places.push_back(i);
  }
  return places.size() == fixed.size() ? places : std::vector<std::size_t>{};
}

std::vector<std::size_t> places_of(const std::vector<SurfacePoint>& fixed,
                                   const SurfaceCurve& curve) {
  if (!curve.closed || fixed.empty()) return places_from(0, fixed, curve);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {  // a loop may begin anywhere
    if (curve.points[i] != fixed.front()) continue;
    std::vector<std::size_t> places = places_from(i, fixed, curve);
    if (!places.empty()) return places;
  }
  return {};
}

/// Where the curve passes way-points, with the point's place among its own.
struct Mark {
  std::size_t point = 0;
  bool is_way_point = false;
  double tolerance = 0;
};

std::vector<Mark> marks_of(const SurfaceCurve& curve, const CurveOptions& options) {
  std::vector<Mark> marks;
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SurfacePoint& point = curve.points[i];
    const auto exact = std::find_if(options.way_points.begin(), options.way_points.end(),
                                    [&](const WayPoint& w) { return w.point == point; });
    const bool is_way_point = exact != options.way_points.end();
    const bool is_end = !curve.closed && (i == 0 || i + 1 == n);
    const auto& pins = options.pins;
    if (is_way_point || is_end || std::find(pins.begin(), pins.end(), point) != pins.end()) {
      marks.push_back({i, is_way_point, is_way_point ? exact->tolerance : 0});
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

DrawnLegs legs_of(const SurfaceCurve& curve, const CurveOptions& options) {
  DrawnLegs legs;
  if (options.way_points.empty()) return legs;
  const std::vector<Mark> marks = marks_of(curve, options);
  const std::size_t m = marks.size(), n = curve.points.size();
  const std::size_t stretches = m == 0 ? 0 : curve.closed ? m : m - 1;
  const auto exact = static_cast<std::size_t>(
      std::count_if(marks.begin(), marks.end(), [](const Mark& k) { return k.is_way_point; }));
  const auto is_painted = [&](std::size_t stretch) {
    const std::size_t to = marks[(stretch + 1) % m].point;
    for (std::size_t i = (marks[stretch].point + 1) % n; i != to; i = (i + 1) % n) {
      const auto& painted = options.painted;
      if (std::find(painted.begin(), painted.end(), curve.points[i]) != painted.end()) return true;
    }
    return false;
  };
  // The stretches between two way-points, with the pins among them, are legs if none is painted.
  std::vector<bool> is_leg(stretches, false);
  const bool may = exact >= (curve.closed ? 3U : 2U);
  for (std::size_t k = 0; may && k < m; ++k) {
    if (!marks[k].is_way_point) continue;
    std::vector<std::size_t> own;
    bool painted = false, ends = false;
    for (std::size_t s = k; !ends && own.size() < stretches && s < (curve.closed ? 2 * m : m - 1);
         ++s) {
      own.push_back(s % m);
      painted = painted || is_painted(s % m);
      ends = marks[(s + 1) % m].is_way_point;
    }
    for (const std::size_t s : own) is_leg[s] = ends && !painted;
  }
  for (const Mark& mark : marks) {
    legs.fixed.push_back(curve.points[mark.point]);
    legs.tolerances.push_back(mark.tolerance);
  }
  legs.is_leg = std::move(is_leg);
  return legs;
}

SurfaceCurve with_legs(const DrawnLegs& legs, const SurfaceCurve& strokes,
                       const SurfaceCurve& straight) {
  const std::vector<std::size_t> from = places_of(legs.fixed, strokes);
  const std::vector<std::size_t> other = places_of(legs.fixed, straight);
  if (from.empty() || other.empty()) return strokes;
  SurfaceCurve result{strokes.closed, {}};
  const std::size_t m = legs.fixed.size();
  for (std::size_t k = 0; k < legs.is_leg.size(); ++k) {
    const SurfaceCurve& source = legs.is_leg[k] ? straight : strokes;
    const std::vector<std::size_t>& places = legs.is_leg[k] ? other : from;
    const std::size_t n = source.points.size();
    for (std::size_t i = places[k]; i != places[(k + 1) % m]; i = (i + 1) % n) {
      result.points.push_back(source.points[i]);
    }
  }
  if (!strokes.closed) result.points.push_back(legs.fixed.back());
  return result;
}

std::optional<LegStart> start_on(const DrawnLegs& legs, const SurfaceCurve& curve,
                                 double relative) {
  LegStart start;
  start.fixed = places_of(legs.fixed, curve);
  if (start.fixed.empty()) return std::nullopt;
  const std::size_t m = start.fixed.size();
  // The curve's own first fixed point may be another one.
  const auto first = static_cast<std::size_t>(
      std::min_element(start.fixed.begin(), start.fixed.end()) - start.fixed.begin());
  std::sort(start.fixed.begin(), start.fixed.end());
  start.tension.relative = relative;
  for (std::size_t k = 0; k < m; ++k) {
    start.tension.tolerances.push_back(legs.tolerances[(first + k) % m]);
  }
  for (std::size_t k = 0; k < legs.is_leg.size(); ++k) {
    start.tension.is_leg.push_back(legs.is_leg[(first + k) % legs.is_leg.size()]);
  }
  return start;
}

}  // namespace talweg
