// The distance of two points is right in tiny and huge units as well.
#pragma once

#include <cmath>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// Within a few ulp wherever the result is a normal number: squares that would leave the range of
/// doubles are scaled first.
inline double point_distance(const Point& p, const Point& q) {
  const Point d = q - p;
  const double squared = d.squaredNorm();
  return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : d.stableNorm();
}

}  // namespace talweg
