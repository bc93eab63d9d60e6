// Default settings at four τ.
#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/self_contacts.hpp"
#include "tools/quality/runs.hpp"

namespace talweg::quality {

std::vector<Run> default_runs(const Subject& subject, const CurveOptions& curve_options,
                              int relax_rounds) {
  const Surface& surface = subject.mesh->surface();
  CurveSmoother smoother(subject.mesh);
  SmoothingOptions options;
  options.relax_rounds = relax_rounds;
  std::vector<Run> runs;
  for (const NamedPath& drawing : subject.drawings) {
    const SurfaceCurve drawn = drawing.curve(surface);
    smoother.set_curve(drawn, curve_options);
    Run run;
    run.mesh = subject.name;
    run.drawing = drawing.name;
    run.closed = drawing.closed;
    run.edge = edge_length_near(surface, drawing.curve(surface));
    const CurveMeasures before = measure_curve(surface, drawn);
    run.curvature_before = before.total_curvature;
    const std::size_t contacts = self_contacts(surface, std::span(&drawn, 1)).size();
    for (const double tau : {0.5, 1.0, 2.0, 4.0}) {
      options.tau = tau;
      const SmoothingResult result = smoother.smooth(options);
      const SmoothingReport& report = result.report();
      run.tau = tau;
      run.bending_before = report.before.bending;
      run.bending_after = report.after.bending;
      run.window_turning = report.after.window_turning;
      run.largest_turn = report.after.max_curvature;
      run.curvature_after = report.after.total_curvature;
      if (drawing.closed) {
        // The total turning of a closed curve is determined by the curvature that it encloses.
        const double after = measure_curve(surface, result.curve()).signed_curvature;
        run.least_curvature = std::min(std::abs(before.signed_curvature), std::abs(after));
      }
      run.to_drawn = report.deviation_to_drawn_max / run.edge;
      run.from_drawn = report.deviation_from_drawn_max / run.edge;
      run.slack = report.slack / run.edge;
      run.length_ratio = report.after.length / report.before.length;
      const StageTimes& times = report.time_ms;
      run.solve_ms = times.solve;
      run.smooth_ms = times.straighten + times.trace + times.relax + times.fair;
      run.termination = report.termination;
      run.warned = !report.warnings.empty();
      run.touches = self_contacts(surface, result.curves).size() > contacts;
      run.left_taut = std::ranges::any_of(report.warnings, [](const std::string& warning) {
        return warning.find("left taut") != std::string::npos;
      });
      runs.push_back(run);
    }
  }
  return runs;
}

}  // namespace talweg::quality
