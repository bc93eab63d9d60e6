#include "talweg/heat/heat_triangles.hpp"

#include <algorithm>
#include <cstddef>

#include "talweg/heat/cotan_laplacian.hpp"

namespace talweg {

std::vector<HeatTriangle> heat_triangles(std::span<const MetricTriangle> triangles) {
  std::vector<HeatTriangle> result;
  result.reserve(triangles.size());
  for (const MetricTriangle& triangle : triangles) {
    const TriangleShape shape = triangle_shape(triangle.length);
    if (!(shape.area > 0)) continue;
    const auto longest = std::max_element(triangle.length.begin(), triangle.length.end());
    const auto first = static_cast<std::size_t>(longest - triangle.length.begin());
    HeatTriangle& t = result.emplace_back();
    t.longest_side = *longest;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = (first + k) % 3;
      t.corner[k] = static_cast<std::uint32_t>(triangle.corner[from].index());
      t.half_cotangent[k] = shape.cotangent[from] / 2;
    }
  }
  return result;
}

}  // namespace talweg
