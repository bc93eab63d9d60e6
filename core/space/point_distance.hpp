// The distance of two points is accurate in tiny and huge units as well.
#pragma once

#include <cmath>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// Accurate to a few ulp if the result is a normal number: squares outside the range of doubles are
/// scaled first.
inline double point_distance(const Point& p, const Point& q) {
  const Point d = q - p;
  const double squared = d.squaredNorm();
  return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : d.stableNorm();
}

}  // namespace talweg
