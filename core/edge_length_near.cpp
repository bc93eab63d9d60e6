#include "talweg/core/edge_length_near.hpp"

#include <algorithm>
#include <vector>

namespace talweg {
namespace {

template <typename Id>
void make_unique(std::vector<Id>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// The halfedges with their tail at v.
template <typename Visit>
void for_spokes(const Surface& surface, VertexId v, const Visit& visit) {
  const HalfedgeId first = surface.halfedge(v);
  if (!first.valid()) return;
  HalfedgeId h = first;
  do {
    visit(h);
    if (!surface.has_face(h)) return;
    h = surface.turn_ccw(h);
  } while (h != first);
}

std::vector<VertexId> vertices_at(const Surface& surface, const SurfaceCurve& curve) {
  std::vector<VertexId> vertices;
  for (const SurfacePoint& point : curve.points) {
    if (const auto* v = std::get_if<AtVertex>(&point.where())) {
      vertices.push_back(v->vertex);
    } else if (const auto* e = std::get_if<OnEdge>(&point.where())) {
      vertices.push_back(surface.tail(halfedge_of(e->edge)));
      vertices.push_back(surface.head(halfedge_of(e->edge)));
    } else {
      for (const VertexId corner : surface.corners(any_face(surface, point))) {
        vertices.push_back(corner);
      }
    }
  }
  make_unique(vertices);
  return vertices;
}

}  // namespace

double edge_length_near(const Surface& surface, const SurfaceCurve& curve) {
  std::vector<VertexId> near = vertices_at(surface, curve);
  for (int ring = 0; ring < 2; ++ring) {
    std::vector<VertexId> more = near;
    for (const VertexId v : near) {
      for_spokes(surface, v, [&](HalfedgeId h) { more.push_back(surface.head(h)); });
    }
    near = std::move(more);
    make_unique(near);
  }
  double sum = 0;
  std::size_t count = 0;
  for (const VertexId v : near) {
    for_spokes(surface, v, [&](HalfedgeId h) {
      const VertexId w = surface.head(h);
      if (w < v) return;  // counted from the other end
      if (!std::binary_search(near.begin(), near.end(), w)) return;
      sum += surface.length(edge_of(h));
      ++count;
    });
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace talweg
