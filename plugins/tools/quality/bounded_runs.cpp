#include "tools/quality/bounded_runs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/max_deviation.hpp"
#include "tools/quality/statistics.hpp"

namespace talweg::quality {
namespace {

constexpr double kBound = 3;  // h₀
constexpr double kTau = 2;

double larger(const Run& run) { return std::max(run.to_drawn, run.from_drawn); }

BoundedRun bounded(const Subject& subject, const NamedPath& drawing, Run run,
                   const CurveOptions& curve_options) {
  const Surface& surface = subject.mesh->surface();
  const SurfaceCurve drawn = drawing.curve(surface);
  BoundedRun result{run.mesh, run.drawing, larger(run)};
  CurveSmoother smoother(subject.mesh);
  smoother.set_curve(drawn, curve_options);
  const SmoothingResult smoothed = smooth_within(smoother, kBound * run.edge);
  const SmoothingReport& report = smoothed.report();
  run.curvature_after = report.after.total_curvature;
  if (run.closed) {
    run.least_curvature =
        std::min(std::abs(measure_curve(surface, drawn).signed_curvature),
                 std::abs(measure_curve(surface, smoothed.curve()).signed_curvature));
  }
  result.ratio = run.ratio();
  result.pins = report.pins_added;
  result.deviation =
      std::max(report.deviation_to_drawn_max, report.deviation_from_drawn_max) / run.edge;
  result.within = result.deviation <= kBound * (1 + 1e-9);
  return result;
}

}  // namespace

std::vector<BoundedRun> bounded_runs(const Subject& subject, std::span<const Run> runs,
                                     const CurveOptions& curve_options) {
  std::vector<BoundedRun> result;
  auto drawing = subject.drawings.begin();  // runs come in the order of the drawings
  for (const Run& run : runs) {
    if (run.tau != kTau) continue;
    if (larger(run) > kBound) result.push_back(bounded(subject, *drawing, run, curve_options));
    ++drawing;
  }
  return result;
}

std::string tables(std::span<const BoundedRun> runs) {
  std::vector<double> ratios;
  for (const BoundedRun& run : runs) {
    if (run.within) ratios.push_back(run.ratio);
  }
  std::string text = fmt::format(
      "Beyond {} h₀ at τ = {}: {} runs. With `--max-deviation` {} h₀: {} within the bound", kBound,
      kTau, runs.size(), kBound, ratios.size());
  if (!ratios.empty()) {
    text += fmt::format("; curvature after / before of these: median {:.3f}, worst {:.3f}",
                        quantile(ratios, 0.5), quantile(ratios, 1));
  }
  text +=
      ".\n\n| mesh | drawing | deviation without [h₀] | with [h₀] | within | curvature after / "
      "before | pinned |\n|---|---|--:|--:|---|--:|--:|\n";
  for (const BoundedRun& run : runs) {
    text +=
        fmt::format("| {} | {} | {:.2f} | {:.2f} | {} | {:.3f} | {} |\n", run.mesh, run.drawing,
                    run.strayed, run.deviation, run.within ? "yes" : "**no**", run.ratio, run.pins);
  }
  return text;
}

}  // namespace talweg::quality
