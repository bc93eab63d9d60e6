// The turning points of a stroke are the points at which the stroke turns.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/measure/measures.hpp"

namespace talweg {

/// The points at which a curve turns by more than 0.02 rad, ascending, without the ends of an open
/// curve. At its other points a curve crosses an edge in a straight line. O(points · degree).
/// Throws as turning_angle() does.
inline std::vector<std::size_t> turning_points(const Surface& surface, const SurfaceCurve& curve) {
  constexpr double kTurn = 0.02;
  const std::size_t n = curve.points.size();
  std::vector<std::size_t> points;
  for (std::size_t k = curve.closed ? 0 : 1; k + (curve.closed ? 0 : 1) < n; ++k) {
    const double turn = turning_angle(surface, curve.points[(k + n - 1) % n], curve.points[k],
                                      curve.points[(k + 1) % n]);
    if (turn > kTurn) points.push_back(k);
  }
  return points;
}

}  // namespace talweg
