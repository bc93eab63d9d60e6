#include "talweg/heat/unit_gradient.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace talweg {
namespace {

/// The triangle's three values, scaled so that the largest has absolute value 1; all 0 where there
/// is no heat.
std::array<double, 3> local_values(const HeatTriangle& triangle, const ScaledField& u) {
  std::array<double, 3> value;
  std::array<std::int32_t, 3> stage;
  for (std::size_t k = 0; k < 3; ++k) {
    value[k] = u.value[triangle.corner[k]];
    stage[k] = u.stage[triangle.corner[k]];
  }
  if (stage[0] != stage[1] || stage[0] != stage[2]) {
    const std::int32_t first = std::min({stage[0], stage[1], stage[2]});
    for (std::size_t k = 0; k < 3; ++k) {
      value[k] = std::ldexp(value[k], -ScaledField::kStageBits * (stage[k] - first));
    }
  }
  const double largest = std::max({std::abs(value[0]), std::abs(value[1]), std::abs(value[2])});
  if (!(largest > 0)) return {0, 0, 0};
  for (double& v : value) v /= largest;
  return value;
}

}  // namespace

std::vector<double> unit_gradient_divergence(std::span<const HeatTriangle> triangles,
                                             const ScaledField& u) {
  std::vector<double> divergence(u.value.size(), 0.0);
  for (const HeatTriangle& triangle : triangles) {
    const std::array<double, 3> value = local_values(triangle, u);
    const auto& weight = triangle.half_cotangent;
    // |∇u| · longest side, from the components of ∇u along this side and across it (height = side /
    // (cot₀ + cot₁)).
    const double along = value[1] - value[0];
    const double across = 2 * ((weight[0] + weight[1]) * (value[2] - value[0]) - weight[0] * along);
    const double steepness = std::sqrt(along * along + across * across);
    if (!(steepness > 0)) continue;
    const double scale = triangle.longest_side / steepness;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double flux = weight[k] * (value[j] - value[i]) * scale;
      divergence[triangle.corner[i]] += flux;
      divergence[triangle.corner[j]] -= flux;
    }
  }
  return divergence;
}

}  // namespace talweg
