#include "curve_subdivision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "methods/arc_length.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::plugins {
namespace {

constexpr double kMostPoints = 20000;  // the most points of a result

SurfacePoint midpoint(const Surface& surface, StraightLines& lines, const SurfacePoint& p,
                      const SurfacePoint& q) {
  if (p == q) return p;
  const std::array<SurfacePoint, 2> ends = {p, q};
  const SurfaceCurve line = lines.join(ends, false);
  const ArcLength arc(surface, line);
  return arc.at(arc.length() / 2);
}

/// The geodesic midpoints between successive points.
std::vector<SurfacePoint> midpoints(const Surface& surface, StraightLines& lines,
                                    const ControlPolygon& polygon) {
  const std::size_t n = polygon.points.size();
  std::vector<SurfacePoint> result;
  for (std::size_t k = 0; k + (polygon.closed ? 0 : 1) < n; ++k) {
    result.push_back(midpoint(surface, lines, polygon.points[k], polygon.points[(k + 1) % n]));
  }
  return result;
}

}  // namespace

ControlPolygon control_polygon(const Surface& surface, const SurfaceCurve& curve, double spacing,
                               int levels) {
  constexpr std::size_t kLeastClosed = 4;
  const ArcLength arc(surface, curve);
  const double wanted = std::round(arc.length() / spacing);
  const double most = std::floor(kMostPoints / std::exp2(levels));
  if (!(wanted <= most)) {
    throw Error(
        ErrorCode::kBadUsage,
        fmt::format("A spacing of {:.3g} with {} levels makes more than {:.0f} points of this "
                    "curve; {:.3g} is the least.",
                    spacing, levels, kMostPoints, arc.length() / most));
  }
  const std::size_t legs =
      std::max(static_cast<std::size_t>(wanted), curve.closed ? kLeastClosed : 1);
  ControlPolygon polygon{curve.closed, {}};
  for (std::size_t k = 0; k < legs + (curve.closed ? 0 : 1); ++k) {
    const double at = static_cast<double>(k) / static_cast<double>(legs);
    polygon.points.push_back(arc.at(at * arc.length()));
  }
  if (!curve.closed) polygon.points.back() = curve.points.back();
  return polygon;
}

ControlPolygon subdivided(const Surface& surface, StraightLines& lines,
                          const ControlPolygon& polygon, int degree) {
  const std::vector<SurfacePoint> between = midpoints(surface, lines, polygon);
  ControlPolygon result{polygon.closed, {}};
  for (std::size_t k = 0; k < polygon.points.size(); ++k) {
    result.points.push_back(polygon.points[k]);
    if (k < between.size()) result.points.push_back(between[k]);
  }
  for (int round = 1; round < degree; ++round) {
    std::vector<SurfacePoint> averaged = midpoints(surface, lines, result);
    if (!result.closed) {
      averaged.insert(averaged.begin(), result.points.front());
      averaged.push_back(result.points.back());
    }
    result.points = std::move(averaged);
  }
  return result;
}

}  // namespace talweg::plugins
