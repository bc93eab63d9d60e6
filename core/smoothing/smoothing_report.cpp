#include "talweg/core/smoothing/smoothing_report.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"

namespace talweg {
namespace {

Outcome outcome_of(Termination termination) {
  switch (termination) {
    case Termination::kConverged:
      return Outcome::kConverged;
    case Termination::kCollapsed:
      return Outcome::kCollapsed;
    case Termination::kLimit:
      return Outcome::kLimit;
    case Termination::kCancelled:
      break;
  }
  return Outcome::kCancelled;
}

void warn_of_straightening(SmoothingReport& report, const SmoothingOptions& options,
                           const DomainResult& smoothed, Termination termination) {
  if (termination == Termination::kLimit && !options.max_iterations &&
      options.min_relative_length == 0) {
    warn_decisively(report,
                    {"Straightening was given up before the curve was straight: the drawing has "
                     "too many points for so few faces."});
  }
  if (termination == Termination::kCollapsed) {
    warn_decisively(report, {"The loop shrinks to a point; the result is the loop as it was when "
                             "its length fell below the least length (length_floor)."});
  }
  if (smoothed.counts.blocked > 0) {
    report.warnings.push_back(
        fmt::format("The curve stays bent at {} points where another part of the drawing is in "
                    "the way.",
                    smoothed.counts.blocked));
  }
}

std::string times(std::size_t count) {
  if (count == 0) return "nowhere";
  return count == 1 ? "once" : fmt::format("{} times", count);
}

void warn_of_crossings(SmoothingReport& report) {
  if (report.crossings_after == report.crossings_before) return;
  std::string sentence =
      fmt::format("The drawing crosses itself and other curves {}, the result {}.",
                  times(report.crossings_before), times(report.crossings_after));
  if (report.crossings_after > report.crossings_before) {
    warn_decisively(report, {std::move(sentence)});
  } else {
    report.warnings.push_back(std::move(sentence));
  }
}

/// The deviation above which a warning is given, mesh units: three edges, or on a refined mesh,
/// whose drawing is finer than the edges, four slacks.
double far_from(double slack, double edge, Engine engine) {
  constexpr double kFarInSlacks = 4;
  return engine == Engine::kRefined ? kFarInSlacks * slack : kFarInEdges * edge;
}

void add_run(SmoothingReport& report, const DomainResult& smoothed) {
  report.potential = smoothed.potential;
  report.engine = smoothed.engine;
  report.flips = smoothed.counts.flips;
  report.iterations = smoothed.counts.iterations;
  report.faces_touched = smoothed.counts.faces_touched;
  report.trace_fallbacks = smoothed.counts.clamped;
  report.mollification = smoothed.mollification;
  report.warnings = smoothed.warnings;
  report.time_ms = smoothed.time_ms;
  report.peak_memory_mib = peak_memory_mib();
}

void add_curve(SmoothingReport& report, const CurveResult& curve) {
  report.slack = curve.slack;
  report.warnings.insert(report.warnings.end(), curve.warnings.begin(), curve.warnings.end());
  if (!curve.left_taut.empty()) warn_decisively(report, {curve.left_taut});
  report.lifted_length_before = curve.path.length_before;
  report.lifted_length_after = curve.path.length_after;
  report.termination = outcome_of(curve.path.termination);
  if (curve.ended_early) report.termination = std::max(report.termination, Outcome::kLimit);
  report.crossings_before = curve.crossings_before;
  report.crossings_after = curve.crossings_after;
  report_deviation(report, curve.deviation);
}

}  // namespace

CurveMeasures turns_on_ground(const SurfaceMesh& ground, const SurfaceCurve& curve, double edge,
                              const CurveMeasures& on_mesh) {
  CurveMeasures measures = measure_curve(ground.surface(), curve, edge);
  measures.length = on_mesh.length;
  measures.tortuosity = on_mesh.tortuosity;
  return measures;
}

SmoothingResult reported(const OpenedMesh& mesh, const OrderedDrawing& drawing,
                         const SmoothingOptions& options, DomainResult smoothed) {
  StageTimes& t = smoothed.time_ms;
  t.open += mesh.open_ms();
  t.total = t.open + t.solve + t.straighten + t.trace + t.relax + t.fair + t.measure;
  SmoothingResult result;
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    const SurfaceCurve& drawn = drawing.curves()[c];
    const double edge = drawing.edges_near()[c];
    SmoothingReport& report = result.reports.emplace_back(
        report_on_curve(mesh.mesh(), drawn, edge, drawing.measures()[c], smoothed.curves[c].curve));
    if (smoothed.ground != nullptr) {
      const SurfaceMesh& ground = *smoothed.ground;
      report.before = drawing.of_drawn(c, turns_on_ground(ground, drawn, edge, report.before));
      report.after = turns_on_ground(ground, smoothed.curves[c].curve, edge, report.after);
    }
    report.after = drawing.in_drawn_direction(c, report.after, report.points_after);
    report.tau = options.tau_of(c);
    const bool given = options.slack_of(c) || !options.slack_at.empty();
    if (smoothed.potential == PotentialKind::kCorridor) {
      report.slack_from = given ? SlackSource::kGiven : drawing.slacks()[c].source;
    }
    add_run(report, smoothed);
    add_curve(report, smoothed.curves[c]);
    if (!smoothed.curves[c].has_legs) {
      warn_if_far(report, far_from(drawing.slacks()[c].slack, edge, smoothed.engine),
                  options.deviation == DeviationMeasure::kAutomatic);
    }
    warn_of_straightening(report, options, smoothed, smoothed.curves[c].path.termination);
    warn_of_crossings(report);
  }
  for (CurveResult& curve : smoothed.curves) result.curves.push_back(std::move(curve.curve));
  return result;
}

SmoothingResult cancelled_result(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                 const SmoothingOptions& options) {
  SmoothingResult result;
  result.curves = drawing.drawn();
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    const std::size_t place = drawing.place_of(c);
    SmoothingReport& report = result.reports.emplace_back(report_on_nothing(
        mesh, result.curves[c], drawing.edges_near()[place], drawing.measures()[place]));
    report.potential = PotentialKind::kPaper;
    report.engine = Engine::kFull;
    report.tau = options.tau_of(c);
    report.termination = Outcome::kCancelled;
  }
  result.total = total_of(result.reports);
  return result;
}

SmoothingReport preview_report(const SurfaceMesh& mesh, DeviationMeter& meter,
                               const SurfaceCurve& drawn, const SurfaceCurve& result,
                               const SmoothingOptions& options, const SmoothingReport& before,
                               const Progress& progress) {
  SmoothingReport report = report_on_curve(mesh, drawn, before.edge_length_near, result);
  report.potential = before.potential;
  report.engine = Engine::kPreview;
  report.tau = before.tau;
  report.slack = before.slack;
  report.termination = before.termination;
  report_deviation(report, measure_deviation(options.deviation_measure(0), report.edge_length_near,
                                             meter, mesh, drawn, result, nullptr, progress));
  warn_if_far(report, kFarInEdges * report.edge_length_near,
              options.deviation == DeviationMeasure::kAutomatic);
  report.peak_memory_mib = before.peak_memory_mib;
  return report;
}

}  // namespace talweg
