#include "talweg/core/drawing/control_points.hpp"

#include <fmt/format.h>

namespace talweg {
namespace {

/// The mean length of the edges of the faces in which the points lie.
double edge_length_near(const SurfaceMesh& mesh, std::span<const SurfacePoint> points) {
  const Surface& surface = mesh.surface();
  double sum = 0;
  for (const SurfacePoint& point : points) {
    const auto corners = surface.corners(any_face(surface, point));
    for (std::size_t k = 0; k < 3; ++k) {
      sum += (mesh.point(corners[k]) - mesh.point(corners[(k + 1) % 3])).norm();
    }
  }
  return sum / static_cast<double>(3 * points.size());
}

double mean_spacing(const SurfaceMesh& mesh, std::span<const SurfacePoint> points, bool closed) {
  const std::size_t n = points.size(), steps = closed ? n : n - 1;
  double sum = 0;
  for (std::size_t k = 0; k < steps; ++k) {
    sum += (mesh.position(points[(k + 1) % n]) - mesh.position(points[k])).norm();
  }
  return sum / static_cast<double>(steps);
}

}  // namespace

std::string why_no_clicks(const SurfaceMesh& mesh, std::span<const SurfacePoint> points,
                          bool closed) {
  if (points.size() > kMostControlPoints) {
    return fmt::format(
        "A curve has {} control points; more than {} are taken as a stroke, not as points that "
        "are meant exactly.",
        points.size(), kMostControlPoints);
  }
  const double spacing = mean_spacing(mesh, points, closed) / edge_length_near(mesh, points);
  if (!(spacing < kLeastSpacing)) return {};
  return fmt::format(
      "A curve's control points lie {:.2g} edges of the mesh apart; closer than {:g} they are "
      "taken as a stroke, not as points that are meant exactly.",
      spacing, kLeastSpacing);
}

}  // namespace talweg
