#include "talweg/core/strokes/even_stroke.hpp"

#include <cstddef>

#include "talweg/core/strokes/compass_walk.hpp"

namespace talweg {
namespace {

Point normal_of(const SurfaceMesh& mesh, FaceId face) {
  const auto corners = mesh.surface().corners(face);
  const Point normal = (mesh.point(corners[1]) - mesh.point(corners[0]))
                           .cross(mesh.point(corners[2]) - mesh.point(corners[0]));
  const double size = normal.norm();
  return size > 0 ? Point(normal / size) : Point::Zero();
}

}  // namespace

EvenStroke even_stroke(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double step) {
  const std::vector<Point> positions = positions_of(mesh, stroke);
  step = walkable_step(positions, stroke.closed, step);
  EvenStroke even{stroke.closed, step, {}, {}};
  const std::size_t n = stroke.points.size();
  std::size_t segment = n;
  Point normal = Point::Zero();
  for (const PolylinePlace& place : compass_walk(positions, stroke.closed, step)) {
    if (place.segment != segment) {
      segment = place.segment;
      normal = normal_of(mesh, common_face(mesh.surface(), stroke.points[segment],
                                           stroke.points[(segment + 1) % n]));
    }
    even.at.push_back(place.at);
    even.normal.push_back(normal);
  }
  return even;
}

}  // namespace talweg
