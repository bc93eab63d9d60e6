#include "talweg/intrinsic/exact_distance/edge_path_distances.hpp"

#include <algorithm>
#include <cstddef>

#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

/// Calls visit(neighbour, length of the edge to it) for every neighbour of v.
template <class Visit>
void for_each_neighbour(const Surface& surface, VertexId v, Visit visit) {
  for_each_spoke(surface, v,
                 [&](HalfedgeId h) { visit(surface.head(h), surface.length(edge_of(h))); });
}

}  // namespace

NearestOnCurve EdgePathDistances::shortest(VertexId v, double exact, const VertexDistances& known,
                                           WorkTally& work) {
  if (const auto found = search_near(v, exact, known)) return *found;
  return search_all(v, exact, known, work);
}

/// Dijkstra's algorithm from the vertex v; empty if the search exceeds kMost vertices.
std::optional<NearestOnCurve> EdgePathDistances::search_near(VertexId v, double exact,
                                                             const VertexDistances& known) {
  constexpr int kMost = 64;  // vertices
  NearestOnCurve best = NearestOnCurve::none();
  reached_.assign(1, {v});
  for (int k = 0; k < kMost; ++k) {
    Reached* next = nullptr;
    for (Reached& r : reached_) {
      if (!r.settled && (next == nullptr || r.way < next->way)) next = &r;
    }
    // Every remaining path leads through a vertex that lies at least next->way from v and farther
    // than `exact` from the curves.
    if (next == nullptr || !(next->way + exact < best.distance)) return best;
    next->settled = true;
    const double way = next->way;
    for_each_neighbour(*surface_, next->vertex, [&](VertexId w, double length) {
      const double longer = way + length;
      if (known[w].distance > exact) {
        reach(w, longer);
      } else if (const auto by_end = known[w].farther_by(longer); by_end.is_nearer_than(best)) {
        best = by_end;
      }
    });
  }
  return {};
}

void EdgePathDistances::reach(VertexId v, double way) {
  const auto before = std::find_if(reached_.begin(), reached_.end(),
                                   [&](const Reached& r) { return r.vertex == v; });
  if (before == reached_.end()) {
    reached_.push_back({v, way});
  } else {
    before->way = std::min(before->way, way);
  }
}

void EdgePathDistances::push(VertexId v, const NearestOnCurve& nearest) {
  queue_.push_back({nearest, v});
  std::push_heap(queue_.begin(), queue_.end(), IsLater{});
}

void EdgePathDistances::start_from_all(double exact, const VertexDistances& known) {
  from_ = exact;
  queue_.clear();
  settled_.clear();
  for (const VertexId v : known.reached()) {
    if (known[v].distance <= exact) push(v, known[v]);
  }
}

/// Dijkstra's algorithm from all vertices with exact distances, continued where the last query
/// stopped.
NearestOnCurve EdgePathDistances::search_all(VertexId v, double exact, const VertexDistances& known,
                                             WorkTally& work) {
  constexpr std::size_t kOfVertex = 8;  // units of work
  if (from_ != exact) start_from_all(exact, known);
  for (;;) {
    if (const auto found = settled_.find(v); found != settled_.end()) return found->second;
    if (queue_.empty()) return NearestOnCurve::none();
    work.report();
    work.add(kOfVertex);
    std::pop_heap(queue_.begin(), queue_.end(), IsLater{});
    const Path next = queue_.back();
    queue_.pop_back();
    if (!settled_.emplace(next.vertex, next.nearest).second) continue;
    for_each_neighbour(*surface_, next.vertex, [&](VertexId w, double length) {
      if (known[w].distance <= exact || settled_.contains(w)) return;
      push(w, next.nearest.farther_by(length));
    });
  }
}

}  // namespace talweg
