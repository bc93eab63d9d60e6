#include "talweg/core/measure/edge_length_near.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

template <typename Id>
void make_unique(std::vector<Id>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
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
  std::vector<VertexId> near = vertices_at(surface, curve), ring = near;
  for (int k = 0; k < 2; ++k) {
    std::vector<VertexId> more;
    for (const VertexId v : ring) {
      for_each_spoke(surface, v, [&](HalfedgeId h) { more.push_back(surface.head(h)); });
    }
    make_unique(more);
    ring.clear();
    std::set_difference(more.begin(), more.end(), near.begin(), near.end(),
                        std::back_inserter(ring));
    const auto middle = static_cast<std::ptrdiff_t>(near.size());
    near.insert(near.end(), ring.begin(), ring.end());
    std::inplace_merge(near.begin(), near.begin() + middle, near.end());
  }
  // Only vertices of the last ring have edges to vertices outside.
  const auto is_in = [](const std::vector<VertexId>& all, VertexId v) {
    return std::binary_search(all.begin(), all.end(), v);
  };
  double sum = 0;
  std::size_t count = 0;
  auto next_of_ring = ring.begin();
  for (const VertexId v : near) {
    const bool last = next_of_ring != ring.end() && *next_of_ring == v;
    if (last) ++next_of_ring;
    for_each_spoke(surface, v, [&](HalfedgeId h) {
      const VertexId w = surface.head(h);
      if (w < v) return;  // counted at its other end
      if (last && !is_in(near, w)) return;
      sum += surface.length(edge_of(h));
      ++count;
    });
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace talweg
