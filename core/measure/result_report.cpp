#include "talweg/core/measure/result_report.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/measure/deviation.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/core/version.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

constexpr double kJump = 0.2;       // mesh edges: a larger move counts as a jump
constexpr double kAutomaticTo = 4;  // mesh edges: beyond, kAutomatic measures through space

}  // namespace

void warn_if_far(SmoothingReport& report, double far, bool automatic) {
  const bool cut = report.deviation_from_drawn_max > report.deviation_to_drawn_max;
  const double apart = cut ? report.deviation_from_drawn_max : report.deviation_to_drawn_max;
  if (!report.deviation_exact) return;  // a bound may be far larger than the deviation
  const bool through_space = automatic && report.deviation == DeviationMeasure::kEuclidean;
  if (!through_space && report.deviation != DeviationMeasure::kAlongSurface) return;
  const bool is_known = through_space && kAutomaticTo * report.edge_length_near > far;
  if (!std::isfinite(apart) || !(apart > far || is_known)) return;
  std::string sentence =
      fmt::format("{} by up to {:.3g}{}, {:.2g} mesh edges, at {}.",
                  cut ? "The result cuts off parts of the drawing that lie away from it"
                      : "The result leaves the drawing",
                  apart, through_space ? " through space" : "", apart / report.edge_length_near,
                  position_text(report.deviation_at, report.edge_length_near));
  if (cut) {
    warn_decisively(report, {std::move(sentence), report.deviation_at});
  } else {
    report.warnings.push_back(std::move(sentence));
  }
}

std::size_t count_touched_faces(const SignpostTriangulation& triangulation) {
  const Surface& surface = triangulation.surface();
  std::vector<FaceId> faces;
  for (const VertexId v : triangulation.touched()) {
    const std::vector<FaceId> around = faces_at(surface, triangulation.location(v));
    faces.insert(faces.end(), around.begin(), around.end());
  }
  std::sort(faces.begin(), faces.end());
  return static_cast<std::size_t>(std::unique(faces.begin(), faces.end()) - faces.begin());
}

namespace {

SmoothingReport report_between(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                               const CurveMeasures& before, const SurfaceCurve& result,
                               const CurveMeasures& after) {
  SmoothingReport report;
  report.version = version();
  report.faces = mesh.surface().face_count();
  report.vertices = mesh.surface().vertex_count();
  report.edge_length_near = edge;
  report.closed = drawn.closed;
  report.points_before = drawn.points.size();
  report.points_after = result.points.size();
  report.before = before;
  report.after = after;
  return report;
}

}  // namespace

SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                const CurveMeasures& before, const SurfaceCurve& result) {
  return report_between(mesh, drawn, edge, before, result, measure_curve(mesh, result, edge));
}

SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                const SurfaceCurve& result) {
  return report_on_curve(mesh, drawn, edge, measure_curve(mesh, drawn, edge), result);
}

SmoothingReport report_on_nothing(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                  const CurveMeasures& measures) {
  SmoothingReport report = report_between(mesh, drawn, edge, measures, drawn, measures);
  report_deviation(report, {});
  return report;
}

namespace {

MeasuredDeviation through_space(const Deviation& apart) {
  return {DeviationMeasure::kEuclidean,
          apart.to_drawn.max,
          apart.to_drawn.mean,
          apart.from_drawn.max,
          apart.from_drawn.mean,
          apart.at,
          true,
          std::max(apart.to_drawn.max, apart.from_drawn.max)};
}

MeasuredDeviation along_surface(const SurfaceMesh& mesh, const SurfaceDeviation& apart) {
  return {DeviationMeasure::kAlongSurface,
          apart.to_drawn.max,
          apart.to_drawn.mean,
          apart.from_drawn.max,
          apart.from_drawn.mean,
          mesh.position(apart.larger().at),
          apart.is_exact(),
          std::max(apart.to_drawn.at_least, apart.from_drawn.at_least)};
}

}  // namespace

MeasuredDeviation measure_deviation(DeviationMeasure measure, double edge_length_near,
                                    DeviationMeter& meter, const SurfaceMesh& mesh,
                                    const SurfaceCurve& drawn, const SurfaceCurve& result,
                                    PolylineDistance* to_drawn, const Progress& progress) {
  const std::span results(&result, 1), drawings(&drawn, 1);
  const auto in_space = [&] {
    return deviation(positions_of(mesh, result), result.closed, positions_of(mesh, drawn),
                     drawn.closed, progress);
  };
  switch (measure) {
    case DeviationMeasure::kAlongSurface:
      return along_surface(mesh, to_drawn != nullptr
                                     ? meter.measure(results, drawings, *to_drawn, progress)
                                     : meter.measure(results, drawings, progress));
    case DeviationMeasure::kEuclidean:
      return through_space(in_space());
    case DeviationMeasure::kAutomatic: {
      const double limit = kAutomaticTo * edge_length_near;
      const Deviation apart = in_space();  // never longer than along the surface, and far cheaper
      std::optional<SurfaceDeviation> along;
      if (std::max(apart.to_drawn.max, apart.from_drawn.max) < limit) {
        along = meter.measure_below(limit, results, drawings, progress);
      }
      return along ? along_surface(mesh, *along) : through_space(apart);
    }
    case DeviationMeasure::kNone:
      break;
  }
  return {};
}

void report_deviation(SmoothingReport& report, const MeasuredDeviation& measured) {
  report.deviation = measured.measure;
  report.deviation_to_drawn_max = measured.to_drawn_max;
  report.deviation_to_drawn_mean = measured.to_drawn_mean;
  report.deviation_from_drawn_max = measured.from_drawn_max;
  report.deviation_from_drawn_mean = measured.from_drawn_mean;
  report.deviation_at = measured.at;
  report.deviation_exact = measured.exact;
  report.deviation_at_least = measured.at_least;
  const double most = std::max(measured.to_drawn_max, measured.from_drawn_max);
  if (measured.spared) {
    report.warnings.push_back(fmt::format(
        "The exact deviation was not measured, because measuring would take far longer than "
        "smoothing: the deviation is {}.",
        bounds_text(measured.at_least, most)));
  } else if (!measured.exact) {
    report.termination = std::max(report.termination, Outcome::kLimit);
    report.warnings.push_back(fmt::format(
        "The budget was used up before the deviation was measured exactly: the deviation is {}.",
        bounds_text(measured.at_least, most)));
  }
  if (measured.measure == DeviationMeasure::kAlongSurface && most == HUGE_VAL) {
    warn_decisively(
        report, {"The result and the drawing lie on parts of the mesh that are not connected."});
  }
}

SmoothingReport report_on_result(const SurfaceMesh& mesh, DeviationMeter& meter,
                                 const SurfaceCurve& drawn, const SurfaceCurve& result,
                                 DeviationMeasure measure) {
  SmoothingReport report =
      report_on_curve(mesh, drawn, edge_length_near(mesh.surface(), drawn), result);
  report.termination = Outcome::kConverged;
  report_deviation(report,
                   measure_deviation(measure, report.edge_length_near, meter, mesh, drawn, result));
  warn_if_far(report, kFarInEdges * report.edge_length_near);
  report.peak_memory_mib = peak_memory_mib();
  return report;
}

void report_move(SmoothingReport& report, const SurfaceMesh& mesh, double last_tau,
                 const SurfaceCurve& last, const SurfaceCurve& result, const Progress& progress) {
  const Deviation moved = deviation(positions_of(mesh, result), result.closed,
                                    positions_of(mesh, last), last.closed, progress);
  report.moved = std::max(moved.to_drawn.max, moved.from_drawn.max);
  if (report.moved <= kJump * report.edge_length_near) return;
  report.warnings.push_back(fmt::format(
      "The curve jumped by {:.3g}, {:.1f} mesh edges, when tau went from {:.4g} to {:.4g}.",
      report.moved, report.moved / report.edge_length_near, last_tau, report.tau));
}

}  // namespace talweg
