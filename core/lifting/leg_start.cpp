#include "talweg/core/lifting/leg_start.hpp"

#include <algorithm>

namespace talweg {
namespace {

/// The indices of the fixed points along the curve, in order, from index `first` on; empty where
/// the curve does not pass all of them. The curve may pass a fixed point again between two others.
std::vector<std::size_t> indices_from(std::size_t first, const std::vector<SurfacePoint>& fixed,
                                      const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  std::vector<std::size_t> indices;
  for (std::size_t steps = 0; steps < n && indices.size() < fixed.size(); ++steps) {
    const std::size_t i = (first + steps) % n;
    if (curve.points[i] == fixed[indices.size()]) indices.push_back(i);
  }
  return indices.size() == fixed.size() ? indices : std::vector<std::size_t>{};
}

std::vector<std::size_t> indices_of(const std::vector<SurfacePoint>& fixed,
                                    const SurfaceCurve& curve) {
  if (!curve.closed || fixed.empty()) return indices_from(0, fixed, curve);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {  // a loop may begin anywhere
    if (curve.points[i] != fixed.front()) continue;
    std::vector<std::size_t> indices = indices_from(i, fixed, curve);
    if (!indices.empty()) return indices;
  }
  return {};
}

}  // namespace

SurfaceCurve with_legs(const DrawnLegs& legs, const SurfaceCurve& strokes,
                       const SurfaceCurve& straight) {
  const std::vector<std::size_t> from = indices_of(legs.fixed, strokes);
  const std::vector<std::size_t> other = indices_of(legs.fixed, straight);
  if (from.empty() || other.empty()) return strokes;
  SurfaceCurve result{strokes.closed, {}};
  const std::size_t m = legs.fixed.size();
  for (std::size_t k = 0; k < legs.is_leg.size(); ++k) {
    const SurfaceCurve& source = legs.is_leg[k] ? straight : strokes;
    const std::vector<std::size_t>& indices = legs.is_leg[k] ? other : from;
    const std::size_t n = source.points.size();
    for (std::size_t i = indices[k]; i != indices[(k + 1) % m]; i = (i + 1) % n) {
      result.points.push_back(source.points[i]);
    }
  }
  if (!strokes.closed) result.points.push_back(legs.fixed.back());
  return result;
}

std::vector<SurfaceCurve> stretches_of(const DrawnLegs& legs, const SurfaceCurve& curve) {
  const std::vector<std::size_t> indices = indices_of(legs.fixed, curve);
  std::vector<SurfaceCurve> stretches;
  const std::size_t n = curve.points.size(), m = indices.size();
  for (std::size_t k = 0; m > 0 && k < legs.is_leg.size(); ++k) {
    SurfaceCurve& stretch = stretches.emplace_back();
    for (std::size_t i = indices[k]; i != indices[(k + 1) % m]; i = (i + 1) % n) {
      stretch.points.push_back(curve.points[i]);
    }
    stretch.points.push_back(curve.points[indices[(k + 1) % m]]);
  }
  return stretches;
}

std::vector<SurfaceCurve> strokes_of(const DrawnLegs& legs, const SurfaceCurve& curve) {
  std::vector<SurfaceCurve> stretches = stretches_of(legs, curve);
  if (!legs.any() || stretches.empty()) return {curve};
  std::vector<SurfaceCurve> strokes;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    if (!legs.is_leg[k]) strokes.push_back(std::move(stretches[k]));
  }
  return strokes;
}

std::vector<bool> on_strokes(const DrawnLegs& legs, const SurfaceCurve& curve) {
  const std::vector<std::size_t> indices = indices_of(legs.fixed, curve);
  const std::size_t n = curve.points.size(), m = indices.size();
  std::vector<bool> on(n, true);
  for (std::size_t k = 0; m > 0 && k < legs.is_leg.size(); ++k) {
    if (!legs.is_leg[k]) continue;
    const std::size_t end = indices[(k + 1) % m];
    for (std::size_t i = (indices[k] + 1) % n; i != end; i = (i + 1) % n) on[i] = false;
  }
  return on;
}

std::vector<std::size_t> stretches_along(const std::vector<SurfacePoint>& fixed,
                                         const SurfaceCurve& curve) {
  const std::vector<std::size_t> indices = indices_of(fixed, curve);
  if (indices.empty()) return {};
  const std::size_t n = curve.points.size(), m = indices.size();
  std::vector<std::size_t> stretches(n, 0);
  for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < m; ++k) {
    for (std::size_t i = indices[k]; i != indices[(k + 1) % m]; i = (i + 1) % n) stretches[i] = k;
  }
  if (!curve.closed && m > 1) stretches[indices.back()] = m - 2;
  return stretches;
}

std::optional<LegStart> start_on(const DrawnLegs& legs, const SurfaceCurve& curve,
                                 double length_exponent) {
  LegStart start;
  start.fixed = indices_of(legs.fixed, curve);
  if (start.fixed.empty()) return std::nullopt;
  const std::size_t m = start.fixed.size();
  // The first fixed point along the curve may be another one than legs.fixed[0].
  const auto first = static_cast<std::size_t>(
      std::min_element(start.fixed.begin(), start.fixed.end()) - start.fixed.begin());
  std::sort(start.fixed.begin(), start.fixed.end());
  start.tension.length_exponent = length_exponent;
  for (std::size_t k = 0; k < m; ++k) {
    start.tension.tolerances.push_back(legs.tolerances[(first + k) % m]);
  }
  for (std::size_t k = 0; k < legs.is_leg.size(); ++k) {
    start.tension.is_leg.push_back(legs.is_leg[(first + k) % legs.is_leg.size()]);
  }
  return start;
}

LegStart reversed(LegStart start, std::size_t points) {
  for (std::size_t& i : start.fixed) i = points - 1 - i;
  std::reverse(start.fixed.begin(), start.fixed.end());
  std::reverse(start.tension.is_leg.begin(), start.tension.is_leg.end());
  std::reverse(start.tension.tolerances.begin(), start.tension.tolerances.end());
  return start;
}

void append(const LegStart& next, std::size_t last, LegStart& start) {
  const auto add = [](const auto& from, auto& to, std::size_t skipped) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(skipped), from.end());
  };
  for (std::size_t k = 1; k < next.fixed.size(); ++k) start.fixed.push_back(last + next.fixed[k]);
  add(next.tension.tolerances, start.tension.tolerances, 1);
  add(next.tension.is_leg, start.tension.is_leg, 0);
}

}  // namespace talweg
