#include "talweg/core/result_report.hpp"

#include <algorithm>
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
  const Deviation apart =
      deviation(positions_of(mesh, result), result.closed, positions_of(mesh, drawn), drawn.closed);
  report.deviation_to_drawn_max = apart.to_drawn.max;
  report.deviation_to_drawn_mean = apart.to_drawn.mean;
  report.deviation_from_drawn_max = apart.from_drawn.max;
  report.deviation_from_drawn_mean = apart.from_drawn.mean;
  report.deviation_at = apart.at;
  return report;
}

}  // namespace talweg
