#include "talweg/core/cutting/vertex_origin.hpp"

#include <cstddef>
#include <variant>

namespace talweg {

VertexOrigin origin_of(const SurfacePoint& point, const Surface& surface, const RepairMap* map) {
  VertexOrigin origin;
  const auto set = [&](std::size_t k, VertexId v, double weight) {
    const VertexId number = map == nullptr ? v : map->file_vertex(v);
    origin.vertices[k] = static_cast<std::uint32_t>(number.index());
    origin.weights[k] = weight;
  };
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    set(0, v->vertex, 1);
  } else if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(e->edge);
    set(0, surface.tail(h), 1 - e->t);
    set(1, surface.head(h), e->t);
  } else {
    const auto& in = std::get<InFace>(point.where());
    const auto corners = surface.corners(in.face);
    for (std::size_t k = 0; k < 3; ++k) set(k, corners[k], in.barycentric[k]);
  }
  return origin;
}

}  // namespace talweg
