// Heat triangles hold the data of each triangle that a distance solve reads, computed once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/flips/delaunay.hpp"

namespace talweg {

/// A triangle whose corners are ordered so that the longest side runs from corner 0 to corner 1.
struct HeatTriangle {
  std::array<std::uint32_t, 3> corner{};
  std::array<double, 3> half_cotangent{};  ///< at each corner: the weight of the opposite side
  double longest_side = 0;
};

/// Triangles without area are left out because no heat flows through them. O(triangles).
std::vector<HeatTriangle> heat_triangles(std::span<const MetricTriangle> triangles);

}  // namespace talweg
