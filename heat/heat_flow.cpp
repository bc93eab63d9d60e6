#include "talweg/heat/heat_flow.hpp"

#include <cmath>
#include <cstddef>

namespace talweg {
namespace {

/// The source that continues the solve from the known vertices into the unknown ones, in units of
/// the next stage. Only sides between a known and an unknown vertex contribute.
std::vector<double> rim_source(std::span<const HeatTriangle> triangles, double time_scale,
                               const ScaledField& u, const std::vector<char>& unknown,
                               const std::vector<char>& reached, std::int32_t stage) {
  std::vector<double> source(u.value.size(), 0.0);
  for (const HeatTriangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t i = triangle.corner[(k + 1) % 3], j = triangle.corner[(k + 2) % 3];
      if (unknown[i] == unknown[j]) continue;
      if (unknown[j] != 0) std::swap(i, j);
      if (reached[j] == 0 || u.stage[j] != stage) continue;
      const double weight = time_scale * triangle.half_cotangent[k];
      source[i] += std::ldexp(weight * u.value[j], ScaledField::kStageBits);
      source[j] -= std::ldexp(weight * u.value[i], ScaledField::kStageBits);
    }
  }
  return source;
}

}  // namespace

ScaledField heat_flow(const CholeskyFactor& factor, std::span<const HeatTriangle> triangles,
                      double time_scale, const std::vector<double>& source,
                      const std::vector<char>& reached, const Progress& progress) {
  ProgressPoller poller(progress, "solve");
  const double small = std::ldexp(1.0, -ScaledField::kStageBits);
  ScaledField u;
  u.value = factor.solve(source);
  u.stage.assign(u.value.size(), 0);
  std::vector<std::size_t> rest;
  std::vector<char> unknown(u.value.size(), 0);
  for (std::size_t i = 0; i < u.value.size(); ++i) {
    if (reached[i] == 0) u.value[i] = 0;
    if (reached[i] == 0 || std::abs(u.value[i]) >= small) continue;
    rest.push_back(i);
    unknown[i] = 1;
  }
  for (std::int32_t stage = 0; !rest.empty(); ++stage) {
    poller.poll();
    const std::vector<double> next =
        factor.solve(rim_source(triangles, time_scale, u, unknown, reached, stage));
    std::vector<std::size_t> still;
    for (const std::size_t i : rest) {
      u.value[i] = std::isfinite(next[i]) ? next[i] : 0.0;
      u.stage[i] = stage + 1;
      if (std::abs(u.value[i]) < small) {
        still.push_back(i);
      } else {
        unknown[i] = 0;
      }
    }
    if (still.size() == rest.size()) break;  // no heat reaches these vertices
    rest = std::move(still);
  }
  return u;
}

ScaledField average(ScaledField a, const ScaledField& b, const std::vector<char>& where) {
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    if (where[i] == 0) continue;
    const int later = b.stage[i] - a.stage[i];
    // A value of b at a later stage than a is negligible. b is at an earlier stage only by rounding
    // near 0.
    const double other = later >= 0 ? std::ldexp(b.value[i], -ScaledField::kStageBits * later) : 0;
    a.value[i] = (a.value[i] + other) / 2;
  }
  return a;
}

}  // namespace talweg
