// The spokes of a vertex are the halfedges that leave it.
#pragma once

#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Calls visit(h) for each halfedge h that leaves a vertex, counterclockwise; the last one at the
/// boundary has no face. None leave an isolated vertex. O(degree).
template <class Visit>
void for_each_spoke(const Surface& surface, VertexId v, const Visit& visit) {
  const HalfedgeId first = surface.halfedge(v);
  for (HalfedgeId h = first; h.valid();) {
    visit(h);
    if (!surface.has_face(h)) return;
    h = surface.turn_ccw(h);
    if (h == first) return;
  }
}

}  // namespace talweg
