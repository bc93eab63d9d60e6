#include "dragged_point.hpp"

#include <algorithm>

namespace talweg::benchmarks {
namespace {

constexpr int kAside = 6;  // edges

/// The neighbour of v that lies farthest from both points.
VertexId farther(const SurfaceMesh& mesh, VertexId v, const Point& a, const Point& b) {
  const Surface& surface = mesh.surface();
  const HalfedgeId first = surface.halfedge(v);
  VertexId best = v;
  double most = 0;
  for (HalfedgeId h = first;;) {
    const Point& p = mesh.point(surface.head(h));
    const double far = (p - a).norm() + (p - b).norm();
    if (far > most) {
      most = far;
      best = surface.head(h);
    }
    if (!surface.has_face(h)) break;
    h = surface.turn_ccw(h);
    if (h == first) break;
  }
  return best;
}

/// Every so many points of a drawing, and the end of an open one.
std::vector<std::size_t> every(std::size_t leg, const SurfaceCurve& drawn) {
  std::vector<std::size_t> points;
  const std::size_t last = drawn.points.size() - 1;
  for (std::size_t i = 0; i <= last; i += leg) points.push_back(i);
  if (!drawn.closed && points.back() != last) points.push_back(last);
  return points;
}

}  // namespace

DraggedPoint::DraggedPoint(const SurfaceMesh& mesh, const SurfaceCurve& drawn, std::size_t leg)
    : DraggedPoint(mesh, drawn, every(leg, drawn), kAside) {}

DraggedPoint::DraggedPoint(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                           const std::vector<std::size_t>& points, int aside)
    : mesh_(&mesh), closed_(drawn.closed) {
  for (const SurfacePoint& point : drawn.points) {
    path_.push_back(std::get<AtVertex>(point.where()).vertex);
  }
  for (const std::size_t i : points) through_.push_back(path_[i]);
  moved_ = through_.size() / 2;
  const Point& a = mesh.point(through_[moved_ - 1]);
  const Point& b = mesh.point(through_[(moved_ + 1) % through_.size()]);
  for (int k = 0; k < aside; ++k) through_[moved_] = farther(mesh, through_[moved_], a, b);
}

SurfaceCurve DraggedPoint::redraw(EdgeDijkstra& dijkstra) const {
  SurfaceCurve curve{closed_, {}};
  for (const VertexId v : dijkstra.redraw(path_, through_, moved_, closed_)) {
    curve.points.push_back(SurfacePoint::at_vertex(mesh_->surface(), v));
  }
  return curve;
}

}  // namespace talweg::benchmarks
