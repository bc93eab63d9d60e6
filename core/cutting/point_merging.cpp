#include "talweg/core/cutting/point_merging.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"

namespace talweg {

double PointMerging::at_least(double size) const {
  if (!(resolution_ > 0)) return merge_;
  return resolution_ < size / 2 ? std::max(merge_, resolution_ / size) : 0.5;
}

std::array<double, 3> PointMerging::in(FaceId face) const {
  std::array<double, 3> near{merge_, merge_, merge_};
  if (!(resolution_ > 0)) return near;
  for (std::size_t k = 0; k < 3; ++k) {
    near[(k + 2) % 3] = at_least(side_frame(surface_, face, k).apex.y);
  }
  return near;
}

bool PointMerging::same(const InFace& p, const InFace& q) const {
  bool same = true;
  for (std::size_t k = 0; k < 3; ++k) {
    same = same && std::abs(p.barycentric[k] - q.barycentric[k]) <= merge_;
  }
  if (same || !(resolution_ > 0)) return same;
  return distance_in_face(surface_, {p.face, p.barycentric}, {q.face, q.barycentric}) <=
         resolution_;
}

SurfacePoint PointMerging::settled(const SurfacePoint& point) const {
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(e->edge);
    const double near = on(e->edge);
    if (e->t <= near) return SurfacePoint::at_vertex(surface_, surface_.tail(h));
    if (e->t >= 1 - near) return SurfacePoint::at_vertex(surface_, surface_.head(h));
    return point;
  }
  if (const auto* f = std::get_if<InFace>(&point.where())) {
    std::array<double, 3> b = f->barycentric;
    const std::array<double, 3> near = in(f->face);
    const auto largest = std::max_element(b.begin(), b.end()) - b.begin();
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (b[k] <= near[k] && static_cast<std::ptrdiff_t>(k) != largest) b[k] = 0;
      sum += b[k];
    }
    for (double& x : b) x /= sum;
    const SurfacePoint moved = SurfacePoint::from_barycentric(surface_, f->face, b);
    if (!std::holds_alternative<InFace>(moved.where())) return settled(moved);
    return point;
  }
  return point;
}

}  // namespace talweg
