#include "talweg/core/result_report.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "talweg/core/deviation.hpp"
#include "talweg/core/version.hpp"

namespace talweg {

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

SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                const CurveMeasures& before, const SurfaceCurve& result) {
  SmoothingReport report;
  report.version = version();
  report.faces = mesh.surface().face_count();
  report.vertices = mesh.surface().vertex_count();
  report.potential = "paper";
  report.engine = "full";
  report.closed = drawn.closed;
  report.points_before = drawn.points.size();
  report.points_after = result.points.size();
  const CurveMeasures after = measure_curve(mesh.surface(), result);
  report.length_before = before.length;
  report.length_after = after.length;
  report.curvature_before = before.total_curvature;
  report.curvature_after = after.total_curvature;
  report.curvature_max_before = before.max_curvature;
  report.curvature_max_after = after.max_curvature;
  return report;
}

void report_deviation(SmoothingReport& report, DeviationMeasure measure, DeviationMeter& meter,
                      const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                      const SurfaceCurve& result, PolylineDistance* to_drawn) {
  const auto take = [&](const auto& to, const auto& from, const Point& at) {
    report.deviation_to_drawn_max = to.max;
    report.deviation_to_drawn_mean = to.mean;
    report.deviation_from_drawn_max = from.max;
    report.deviation_from_drawn_mean = from.mean;
    report.deviation_at = at;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  switch (measure) {
    case DeviationMeasure::kAlongSurface: {
      report.deviation = "surface";
      const std::span results(&result, 1), drawings(&drawn, 1);
      const SurfaceDeviation apart = to_drawn != nullptr
                                         ? meter.measure(results, drawings, *to_drawn)
                                         : meter.measure(results, drawings);
      take(apart.to_drawn, apart.from_drawn, mesh.position(apart.larger().at));
      if (apart.larger().max == kInfinity) {
        report.warnings.emplace_back(
            "The result and the drawing lie on parts of the mesh that are not connected.");
      }
      break;
    }
    case DeviationMeasure::kEuclidean: {
      report.deviation = "euclidean";
      const Deviation apart = deviation(positions_of(mesh, result), result.closed,
                                        positions_of(mesh, drawn), drawn.closed);
      take(apart.to_drawn, apart.from_drawn, apart.at);
      break;
    }
    case DeviationMeasure::kNone: {
      report.deviation = "none";
      const OneSidedDeviation unknown{kInfinity, kInfinity};
      take(unknown, unknown, Point::Constant(kInfinity));
      break;
    }
  }
}

}  // namespace talweg
