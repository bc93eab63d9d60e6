#include "talweg/intrinsic/exact_distance/bending_vertices.hpp"

#include <numbers>

#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

BendingVertices::BendingVertices(const Surface& surface)
    : surface_(&surface), known_(surface.vertex_count(), kUnknown) {}

bool BendingVertices::compute(VertexId v) const {
  constexpr double kSlack = 1e-7;  // radians; a bend left out changes a length by less than kSlack²
  double sum = surface_->on_boundary(v) ? std::numbers::pi : 0.0;
  bool no_length = false;
  const HalfedgeId first = surface_->halfedge(v);
  HalfedgeId h = first;
  while (h.valid()) {
    const double length = surface_->length(edge_of(h));
    no_length |= length <= 0;
    if (!surface_->has_face(h)) break;
    sum += angle_between(length, surface_->length(edge_of(surface_->prev(h))),
                         surface_->length(edge_of(surface_->next(h))));
    h = surface_->turn_ccw(h);
    if (h == first) break;
  }
  return no_length || sum > 2 * std::numbers::pi + kSlack;
}

}  // namespace talweg
