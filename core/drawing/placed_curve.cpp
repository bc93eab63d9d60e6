#include "talweg/core/drawing/placed_curve.hpp"

#include <string>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// Barycentrics from which SurfacePoint::on_edge() restores t bit for bit, since 1 - t is computed
/// only once.
FaceCoordinates exact_coordinates(const Surface& surface, const SurfacePoint& point, FaceId face) {
  FaceCoordinates at = coordinates_in(surface, point, face);
  if (const auto* edge = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(edge->edge);
    const auto corners = surface.corners(face);
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] == surface.tail(h)) at.barycentric[k] = 1 - edge->t;
      if (corners[k] == surface.head(h)) at.barycentric[k] = edge->t;
    }
  }
  return at;
}

}  // namespace

PlacedCurve place(const SurfaceMesh& mesh, const SurfaceCurve& curve, std::size_t number) {
  const std::string name = "Curve " + std::to_string(number);
  const std::size_t n = curve.points.size();
  if (n < 2) throw Error(ErrorCode::kBadCurve, name + " has fewer than two points.");
  PlacedCurve result{curve.closed, {}, {}, positions_of(mesh, curve), {}};
  result.vertex_count = mesh.surface().vertex_count();
  for (std::size_t k = 0; k < n; ++k) {
    const bool last = k + 1 == n && !curve.closed;
    const SurfacePoint& next = last ? curve.points[k - 1] : curve.points[(k + 1) % n];
    const FaceId face = common_face(mesh.surface(), curve.points[k], next);
    if (!face.valid()) {
      throw Error(ErrorCode::kBadCurve,
                  name + ": point " + std::to_string(k) + " and the next lie in no common face.");
    }
    result.faces.push_back(exact_coordinates(mesh.surface(), curve.points[k], face));
    result.corners.push_back(mesh.surface().corners(face));
    const auto* at = std::get_if<AtVertex>(&curve.points[k].where());
    result.vertices.push_back(at == nullptr ? VertexId{} : at->vertex);
  }
  return result;
}

}  // namespace talweg
