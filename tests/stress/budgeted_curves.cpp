#include "stress/budgeted_curves.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/smoothing/max_deviation.hpp"

namespace talweg::stress {
namespace {

SmoothingResult smoothed(CurveSmoother& smoother, const SmoothingOptions& options, double bound) {
  return bound > 0 ? smooth_within(smoother, bound, options) : smoother.smooth(options);
}

bool same(const SmoothingResult& a, const SmoothingResult& b) {
  return std::ranges::equal(a.curves, b.curves, [](const SurfaceCurve& x, const SurfaceCurve& y) {
    return x.points == y.points;
  });
}

bool was_used_up(const SmoothingResult& result) {
  const auto says = [](const std::string& warning) {
    return warning.find("budget was used up") != std::string::npos;
  };
  return std::ranges::any_of(result.total.warnings, says) ||
         std::ranges::any_of(result.reports, [&](const SmoothingReport& report) {
           return std::ranges::any_of(report.warnings, says);
         });
}

/// Checks the deviations in reports of curves that were not measured to the end; returns a fault or
/// "". Drawings with way-points are not checked: only strokes count there, and strokes are not
/// known here.
std::string tells_too_little(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                             const SmoothingResult& result) {
  DeviationMeter meter(mesh);
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    const SmoothingReport& report = result.reports[c];
    if (report.deviation_exact || report.deviation != DeviationMeasure::kAlongSurface) continue;
    const double told = std::max(report.deviation_to_drawn_max, report.deviation_from_drawn_max);
    if (report.deviation_at_least > told) return "the least deviation is more than the most";
    if (std::isinf(told)) continue;
    const double exact =
        meter.measure(std::span(&result.curves[c], 1), drawn.subspan(c, 1)).larger().max;
    // The meter is exact up to 1e-3 of the distance or of a mean edge. Points left out of the
    // drawing are reported separately.
    const double most = told + report.left_out_max;
    if (exact > most * (1 + 2e-3) + 2e-3 * mesh.mean_edge_length()) {
      return fmt::format("curve {} is {:.6g} away, not {:.6g}", c, exact, told);
    }
  }
  return "";
}

}  // namespace

std::string breaks_its_budget(CurveSmoother& smoother, SmoothingOptions options, double bound,
                              Random& random) {
  const std::vector<SurfaceCurve> drawn(smoother.drawn().begin(), smoother.drawn().end());
  const SmoothingResult plain = smoothed(smoother, options, bound);
  SmoothingOptions with = options;
  with.budget.work = static_cast<std::uint64_t>(random.scale(1, 1e7));
  const auto anew = [&] {
    smoother.set_curves(drawn, CurveOptions(smoother.curve_options()));
    return smoothed(smoother, with, bound);
  };
  const SmoothingResult result = anew();
  const std::string work = fmt::format("work {}: ", *with.budget.work);
  if (!same(smoothed(smoother, options, bound), plain)) return work + "something was left behind";
  if (!same(anew(), result)) return work + "not the same again";
  const bool ended = was_used_up(result);
  if (!ended && !same(result, plain)) return work + "another result, and nothing was said";
  if (ended && result.total.termination < Outcome::kLimit) return work + "the end is not a limit";
  if (!smoother.curve_options().way_points.empty()) return "";
  const std::string too_little = tells_too_little(smoother.opened().mesh(), drawn, result);
  return too_little.empty() ? "" : work + too_little;
}

}  // namespace talweg::stress
