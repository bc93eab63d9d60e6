#include "stress/redrawn_curves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/smoothing/max_deviation.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::stress {
namespace {

struct Redrawn {
  std::size_t from = 0;  // number of the curve
  bool reversed = false;
  SurfaceCurve curve;
};

std::vector<Redrawn> redrawn(std::span<const SurfaceCurve> drawn, Random& random) {
  std::vector<Redrawn> all;
  all.reserve(drawn.size());
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    Redrawn& one = all.emplace_back(Redrawn{c, random.one_in(2), drawn[c]});
    std::vector<SurfacePoint>& points = one.curve.points;
    if (one.reversed) std::reverse(points.begin(), points.end());
    if (!one.curve.closed) continue;
    const auto start = static_cast<std::ptrdiff_t>(random.below(points.size()));
    std::rotate(points.begin(), points.begin() + start, points.end());
  }
  for (std::size_t k = all.size(); k > 1; --k) std::swap(all[k - 1], all[random.below(k)]);
  return all;
}

/// Whether two points are equal up to rounding, which the canonical order ignores.
bool are_same(const SurfacePoint& p, const SurfacePoint& q) {
  constexpr double kRounding = 1e-9;
  const auto *e = std::get_if<OnEdge>(&p.where()), *f = std::get_if<OnEdge>(&q.where());
  return p == q ||
         (e != nullptr && f != nullptr && e->edge == f->edge && std::abs(e->t - f->t) < kRounding);
}

/// Whether a curve equals its reverse, like a curve that runs out and back.
bool is_its_own_reverse(const SurfaceCurve& curve) {
  std::vector<SurfacePoint> around = curve.points;
  if (curve.closed) around.insert(around.end(), curve.points.begin(), curve.points.end());
  return std::search(around.begin(), around.end(), curve.points.rbegin(), curve.points.rend(),
                     are_same) != around.end();
}

}  // namespace

std::string differs_when_redrawn(CurveSmoother& smoother, const CurveOptions& curve_options,
                                 const SmoothingOptions& options, double bound, Random& random) {
  const auto smoothed = [&] {
    return bound > 0 ? smooth_within(smoother, bound, options) : smoother.smooth(options);
  };
  const std::vector<SurfaceCurve> drawn(smoother.drawn().begin(), smoother.drawn().end());
  const SmoothingResult expected = smoothed();
  const std::vector<Redrawn> others = redrawn(drawn, random);
  std::vector<SurfaceCurve> curves;
  curves.reserve(others.size());
  for (const Redrawn& other : others) curves.push_back(other.curve);
  try {
    smoother.set_curves(curves, curve_options);
  } catch (const Error& error) {
    return fmt::format("refused when redrawn: {}", error.what());
  }
  const SmoothingResult found = smoothed();
  for (std::size_t k = 0; k < others.size(); ++k) {
    const Redrawn& other = others[k];
    std::vector<SurfacePoint> points = found.curves[k].points;
    const std::vector<SurfacePoint>& before = expected.curves[other.from].points;
    const bool may_stay = is_its_own_reverse(other.curve) && points == before;
    if (other.reversed && !may_stay) std::reverse(points.begin(), points.end());
    if (points != before) {
      return fmt::format("curve {}, {}redrawn, has another result", other.from,
                         other.curve.closed ? "closed, " : "");
    }
    if (found.reports[k].slack != expected.reports[other.from].slack) {
      return fmt::format("curve {}, redrawn, has another slack", other.from);
    }
  }
  return {};
}

}  // namespace talweg::stress
