#include "talweg/core/drawing/surface_normals.hpp"

#include <array>
#include <cmath>

namespace talweg {
namespace {

std::array<Point, 3> corners_of(const SurfaceMesh& mesh, FaceId face) {
  const auto ids = mesh.surface().corners(face);
  return {mesh.point(ids[0]), mesh.point(ids[1]), mesh.point(ids[2])};
}

/// The angle of the face at the point if the point is a vertex, else 1.
double weight_of(const SurfaceMesh& mesh, FaceId face, const AtVertex* at) {
  if (at == nullptr) return 1;
  const auto ids = mesh.surface().corners(face);
  const std::array<Point, 3> p = corners_of(mesh, face);
  for (std::size_t k = 0; k < 3; ++k) {
    if (ids[k] != at->vertex) continue;
    const Point a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return 0;
}

}  // namespace

Point normal_at(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const auto* at = std::get_if<AtVertex>(&point.where());
  Point sum = Point::Zero();
  for (const FaceId face : faces_at(mesh.surface(), point)) {
    const std::array<Point, 3> p = corners_of(mesh, face);
    const Point normal = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
    sum += weight_of(mesh, face, at) * normal;
  }
  const double length = sum.norm();
  return length > 0 ? Point(sum / length) : Point(Point::Zero());
}

void set_normals(const SurfaceMesh& mesh, PlacedCurve& curve) {
  curve.normals.clear();
  for (const FaceCoordinates& at : curve.faces) {
    curve.normals.push_back(
        normal_at(mesh, SurfacePoint::from_barycentric(mesh.surface(), at.face, at.barycentric)));
  }
}

}  // namespace talweg
