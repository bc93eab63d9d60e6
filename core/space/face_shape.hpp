// The shape of a face: its smallest angle, and whether the face is flat.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "talweg/core/space/point.hpp"
#include "talweg/core/space/point_distance.hpp"

namespace talweg {

/// `flat` if twice the area is within the rounding of a cross product, relative to the square of
/// the longest side. The angle of a flat face is meaningless.
struct FaceShape {
  double smallest_angle = 0;  ///< radians
  bool flat = false;
};

inline FaceShape shape_of(const std::array<Point, 3>& p) {
  std::array<double, 3> length{};
  for (std::size_t k = 0; k < 3; ++k) length[k] = point_distance(p[k], p[(k + 1) % 3]);
  const auto shortest =
      static_cast<std::size_t>(std::min_element(length.begin(), length.end()) - length.begin());
  const double longest = *std::max_element(length.begin(), length.end());
  if (!(longest > 0)) return {0, true};
  // The smallest angle lies opposite the shortest side; side k runs from corner k to k + 1. The
  // vectors are scaled, so that tiny units do not underflow.
  const Point& tip = p[(shortest + 2) % 3];
  const Point a = (p[shortest] - tip) / longest;
  const Point b = (p[(shortest + 1) % 3] - tip) / longest;
  const double area = a.cross(b).norm();
  return {std::atan2(area, a.dot(b)), area <= 4 * std::numeric_limits<double>::epsilon()};
}

}  // namespace talweg
