#include "level_set_matching.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "talweg/core/measure/deviation.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg::plugins {
namespace {

struct Pair {
  double apart = 0;
  std::size_t drawn = 0, found = 0;
};

std::vector<Pair> pairs_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                           const std::vector<SurfaceCurve>& set) {
  std::vector<Pair> pairs;
  for (std::size_t d = 0; d < drawn.size(); ++d) {
    for (std::size_t s = 0; s < set.size(); ++s) {
      if (drawn[d].closed != set[s].closed) continue;
      const Deviation apart = deviation(positions_of(mesh, set[s]), set[s].closed,
                                        positions_of(mesh, drawn[d]), drawn[d].closed);
      pairs.push_back({apart.from_drawn.mean, d, s});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.apart, a.drawn, a.found) < std::tie(b.apart, b.drawn, b.found);
  });
  return pairs;
}

/// The curve with the drawn curve's direction and, if closed, its start.
SurfaceCurve aligned(const Surface& surface, const SurfaceCurve& drawn, SurfaceCurve curve) {
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  const double length = distance.curve_length(0);
  std::vector<double> arcs;
  for (const SurfacePoint& p : curve.points) arcs.push_back(distance.at(p).arc_length);
  double forward = 0;
  const std::size_t n = arcs.size();
  for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
    const double step = arcs[(k + 1) % n] - arcs[k];
    forward += curve.closed ? step - length * std::round(step / length) : step;
  }
  if (forward < 0) {
    std::reverse(curve.points.begin(), curve.points.end());
    std::reverse(arcs.begin(), arcs.end());
  }
  if (curve.closed) {
    const auto first = std::min_element(arcs.begin(), arcs.end()) - arcs.begin();
    std::rotate(curve.points.begin(), curve.points.begin() + first, curve.points.end());
  }
  return curve;
}

}  // namespace

MatchedCurves match(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                    std::vector<SurfaceCurve> set) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> partner(drawn.size(), kNone);
  std::vector<char> taken(set.size(), 0);
  for (const Pair& pair : pairs_of(mesh, drawn, set)) {
    if (partner[pair.drawn] != kNone || taken[pair.found] != 0) continue;
    partner[pair.drawn] = pair.found;
    taken[pair.found] = 1;
  }
  MatchedCurves result;
  for (std::size_t d = 0; d < drawn.size(); ++d) {
    if (partner[d] == kNone) {
      throw Error(ErrorCode::kNumerical,
                  fmt::format("The level set, of {} curves, has none for drawn curve {}: a failure "
                              "that this method is known for.",
                              set.size(), d + 1));
    }
    result.curves.push_back(aligned(mesh.surface(), drawn[d], set[partner[d]]));
  }
  for (std::size_t s = 0; s < set.size(); ++s) {
    if (taken[s] == 0) result.others.push_back(std::move(set[s]));
  }
  return result;
}

}  // namespace talweg::plugins
