// PolylineDistance: exact nearby, ways along edges beyond.
#include <algorithm>
#include <limits>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

using Nearest = PolylineDistance::Nearest;

constexpr double kNoWay = std::numeric_limits<double>::infinity();

/// Calls visit(edge to it, neighbour) for every neighbour of v.
template <class Visit>
void for_each_neighbour(const Surface& surface, VertexId v, Visit visit) {
  const HalfedgeId first = surface.halfedge(v);
  for (HalfedgeId h = first; h.valid();) {
    visit(h, surface.head(h));
    if (!surface.has_face(h)) break;
    h = surface.turn_ccw(h);
    if (h == first) break;
  }
}

}  // namespace

void PolylineDistance::reach_along(HalfedgeId spoke, double way) {
  const VertexId v = surface_->head(spoke);
  const auto known = std::find_if(reached_.begin(), reached_.end(),
                                  [&](const Reached& r) { return r.vertex == v; });
  if (known == reached_.end()) {
    reached_.push_back({v, way});
  } else {
    known->way = std::min(known->way, way);
  }
}

Nearest PolylineDistance::at_vertex_roughly(VertexId v, double exact) {
  constexpr int kMost = 64;  // vertices
  const Nearest& known = vertex_[v.index()];
  while (!is_final(std::min(known.distance, exact)) && !marches_in_vain(v)) march();
  if (known.distance <= exact || marches_in_vain(v)) return finish(known);

  Nearest best{kNoWay, 0, 0};
  reached_.assign(1, {v});
  for (int k = 0; k < kMost; ++k) {
    Reached* next = nullptr;
    for (Reached& r : reached_) {
      if (!r.settled && (next == nullptr || r.way < next->way)) next = &r;
    }
    // Every remaining way leads through a vertex that lies at least next->way from v and farther
    // than `exact` from the curves.
    if (next == nullptr || !(next->way + exact < best.distance)) return finish(best);
    next->settled = true;
    const double way = next->way;
    for_each_neighbour(*surface_, next->vertex, [&](HalfedgeId h, VertexId w) {
      const Nearest& end = vertex_[w.index()];
      const double longer = way + surface_->length(edge_of(h));
      if (end.distance > exact) {
        reach_along(h, longer);
      } else if (const Nearest by_end = farther(end, longer); is_nearer(by_end, best)) {
        best = by_end;
      }
    });
  }
  return finish(along_edges(v, exact));
}

/// Searches from the other end, by Dijkstra's algorithm from all exact distances, continuing where
/// the last query stopped. Exact distances would cost far more: where faces are needles, the number
/// of windows grows with the square of the number of edges.
Nearest PolylineDistance::along_edges(VertexId v, double exact) {
  constexpr std::size_t kOfVertex = 8;  // units of work
  const auto is_later = [](const EdgeWay& a, const EdgeWay& b) {
    return is_nearer(b.nearest, a.nearest);
  };
  const auto push = [&](VertexId to, const Nearest& nearest) {
    edge_ways_.push_back({nearest, to});
    std::push_heap(edge_ways_.begin(), edge_ways_.end(), is_later);
  };
  if (edge_ways_from_ != exact) {
    edge_ways_from_ = exact;
    edge_ways_.clear();
    by_edges_.clear();
    for (const VertexId touched : touched_vertices_) {
      const Nearest& nearest = vertex_[touched.index()];
      if (nearest.distance <= exact) push(touched, nearest);
    }
  }
  for (;;) {
    if (const auto known = by_edges_.find(v); known != by_edges_.end()) return known->second;
    if (edge_ways_.empty()) return {kNoWay, 0, 0};
    tell_work();
    work_ += kOfVertex;
    std::pop_heap(edge_ways_.begin(), edge_ways_.end(), is_later);
    const EdgeWay next = edge_ways_.back();
    edge_ways_.pop_back();
    if (!by_edges_.emplace(next.vertex, next.nearest).second) continue;
    for_each_neighbour(*surface_, next.vertex, [&](HalfedgeId h, VertexId w) {
      if (vertex_[w.index()].distance <= exact || by_edges_.contains(w)) return;
      push(w, farther(next.nearest, surface_->length(edge_of(h))));
    });
  }
}

}  // namespace talweg
