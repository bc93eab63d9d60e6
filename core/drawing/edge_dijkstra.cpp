#include "talweg/core/drawing/edge_dijkstra.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "talweg/core/drawing/edge_landmarks.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

constexpr std::size_t kOfEntry = 8;  // units of work

std::string text(VertexId v) { return std::to_string(v.index()); }

}  // namespace

bool EdgeDijkstra::later(const Entry& a, const Entry& b) {
  return a.distance != b.distance ? a.distance > b.distance : a.vertex > b.vertex;
}

EdgeDijkstra::EdgeDijkstra(const Surface& surface)
    : surface_(&surface),
      block_stamp_(surface.vertex_count(), 0),
      reach_stamp_(surface.vertex_count(), 0),
      settled_stamp_(surface.vertex_count(), 0),
      distance_(surface.vertex_count()),
      parent_(surface.vertex_count()) {}

EdgeDijkstra::~EdgeDijkstra() = default;

std::vector<VertexId> EdgeDijkstra::draw(std::span<const VertexId> through, bool closed,
                                         const Progress& progress) {
  poller_ = ProgressPoller(progress, "draw");
  return drawn(through, closed);
}

std::vector<VertexId> EdgeDijkstra::drawn(std::span<const VertexId> through, bool closed) {
  check(through);
  ++drawing_;
  for (const VertexId v : through) block_stamp_[v.index()] = drawing_;

  std::vector<VertexId> path{through.front()};
  const std::size_t legs = closed ? through.size() : through.size() - 1;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    poller_.set_fraction(static_cast<double>(leg) / static_cast<double>(legs));
    const VertexId from = through[leg];
    const VertexId to = through[(leg + 1) % through.size()];
    // A closed path needs a third vertex: the last leg must not return along the path's only edge.
    const bool not_along_edge = leg + 1 == legs && path.size() == 2 && closed;
    const std::size_t first_new = path.size();
    if (!append_leg(from, to, not_along_edge, path)) no_path(leg + 1, from, to);
    for (std::size_t i = first_new; i < path.size(); ++i) {
      block_stamp_[path[i].index()] = drawing_;
    }
  }
  if (closed) path.pop_back();
  return path;
}

/// Appends the legs before and after a moved way-point `over`. An invalid `from` or `to` means that
/// there is no such leg. False if a leg has no path.
bool EdgeDijkstra::append_redrawn(VertexId from, VertexId over, VertexId to,
                                  std::vector<VertexId>& path) {
  const std::size_t first_new = path.size();
  if (!from.valid()) {
    path.push_back(over);
  } else if (!append_leg(from, over, false, path)) {
    return false;
  }
  for (std::size_t i = first_new; i < path.size(); ++i) block_stamp_[path[i].index()] = drawing_;
  return !to.valid() || append_leg(over, to, false, path);
}

std::vector<VertexId> EdgeDijkstra::redraw(std::span<const VertexId> path,
                                           std::span<const VertexId> through, std::size_t moved,
                                           bool closed, const Progress& progress) {
  poller_ = ProgressPoller(progress, "draw");
  check(through);
  const std::size_t n = through.size();
  if (moved >= n) throw Error(ErrorCode::kBadUsage, "redraw() is asked for a missing way-point.");
  if (closed && n < 3) return drawn(through, closed);
  const bool has_before = closed || moved > 0, has_after = closed || moved + 1 < n;
  const VertexId before = has_before ? through[(moved + n - 1) % n] : VertexId{};
  const VertexId after = has_after ? through[(moved + 1) % n] : VertexId{};

  // Parts of the path stay: in an open path, `head` up to the way-point `before`, and `tail` from
  // the way-point `after` on; in a closed path, `head` from `after` to `before`.
  std::vector<VertexId> head(path.begin(), path.end()), tail;
  const auto at = [&](VertexId v) { return std::find(head.begin(), head.end(), v); };
  if ((has_before && at(before) == head.end()) || (has_after && at(after) == head.end())) {
    return drawn(through, closed);
  }
  if (closed) {
    std::rotate(head.begin(), at(after), head.end());
  } else if (has_after) {
    tail.assign(at(after) + 1, head.end());
  }
  head.erase(has_before ? at(before) + 1 : head.begin(), head.end());
  ++drawing_;
  for (const auto& stays : {std::span<const VertexId>(head), std::span<const VertexId>(tail),
                            std::span<const VertexId>(through)}) {
    for (const VertexId v : stays) {
      if (v == through[moved] && stays.data() != through.data()) return drawn(through, closed);
      block_stamp_[v.index()] = drawing_;
    }
  }
  std::vector<VertexId> result = std::move(head);
  if (!append_redrawn(before, through[moved], after, result)) return drawn(through, closed);
  result.insert(result.end(), tail.begin(), tail.end());
  if (!closed) return result;
  result.pop_back();  // the way-point `after`, with which the result also begins
  std::rotate(result.begin(), std::find(result.begin(), result.end(), through.front()),
              result.end());
  return result;
}

void EdgeDijkstra::check(std::span<const VertexId> through) const {
  if (through.size() < 2) {
    throw Error(ErrorCode::kBadCurve, "A drawing needs at least 2 way-points, not " +
                                          std::to_string(through.size()) + ".");
  }
  for (const VertexId v : through) {
    if (v.index() >= surface_->vertex_count()) {
      throw Error(ErrorCode::kBadCurve, "Way-point " + text(v) + " is not a vertex: the mesh has " +
                                            std::to_string(surface_->vertex_count()) + ".");
    }
  }
  std::vector<VertexId> sorted(through.begin(), through.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    throw Error(ErrorCode::kBadCurve, "Vertex " + text(*twice) + " is a way-point twice.");
  }
}

bool EdgeDijkstra::append_leg(VertexId from, VertexId to, bool not_along_edge,
                              std::vector<VertexId>& path) {
  if (!search(from, to, not_along_edge, /*obey_blocks=*/true)) return false;
  const std::size_t first_new = path.size();
  for (VertexId v = to; v != from; v = parent_[v.index()]) path.push_back(v);
  std::reverse(path.begin() + static_cast<std::ptrdiff_t>(first_new), path.end());
  return true;
}

bool EdgeDijkstra::search(VertexId from, VertexId to, bool not_along_edge, bool obey_blocks) {
  constexpr std::size_t kPatience = 16;  // searches of the whole mesh; landmarks cost nine
  if (!landmarks_ && looked_at_ > kPatience * surface_->vertex_count()) {
    landmarks_ = std::make_unique<EdgeLandmarks>(*surface_, from, poller_);
  }
  if (landmarks_ && obey_blocks) {
    search_with_landmarks(from, to, not_along_edge);
    if (!reached(to)) return false;
    if (find_parents(from, to, not_along_edge)) return true;
  }
  return search_around(from, to, not_along_edge, obey_blocks);
}

/// Calls `visit` with each neighbour and the length of the edge to it.
template <class Visit>
void EdgeDijkstra::visit_neighbours(VertexId vertex, const Visit& visit) const {
  for_each_spoke(*surface_, vertex,
                 [&](HalfedgeId h) { visit(surface_->head(h), surface_->length(edge_of(h))); });
}

bool EdgeDijkstra::search_around(VertexId from, VertexId to, bool not_along_edge,
                                 bool obey_blocks) {
  ++search_;
  heap_.clear();
  reach(from, VertexId{}, 0);
  while (!heap_.empty()) {
    poller_.add_work(kOfEntry);
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Entry top = heap_.back();
    heap_.pop_back();
    if (settled_stamp_[top.vertex.index()] == search_) continue;
    settled_stamp_[top.vertex.index()] = search_;
    ++looked_at_;
    if (top.vertex == to) return true;
    visit_neighbours(top.vertex, [&](VertexId v, double length) {
      const bool closed_way = (obey_blocks && v != to && blocked(v)) ||
                              (not_along_edge && top.vertex == from && v == to);
      if (closed_way || settled_stamp_[v.index()] == search_) return;
      const std::size_t size = heap_.size();
      reach(v, top.vertex, top.distance + length);
      if (heap_.size() > size) std::push_heap(heap_.begin(), heap_.end(), later);
    });
  }
  return false;
}

/// A* search. The distances of all vertices on shortest paths are those of search_around(): a
/// vertex is visited again when a shorter path to it is found, and the search ends only when no
/// other path can be as short, up to rounding.
void EdgeDijkstra::search_with_landmarks(VertexId from, VertexId to, bool not_along_edge) {
  constexpr double kAsShort = 1 + 1e-9;
  ++search_;
  heap_.clear();
  landmarks_->aim(to);
  const auto go_to = [&](VertexId v, double distance) {
    if (reached(v) && distance >= distance_[v.index()]) return;
    reach_stamp_[v.index()] = search_;
    distance_[v.index()] = distance;
    heap_.push_back({distance + landmarks_->bound(v), v});
    std::push_heap(heap_.begin(), heap_.end(), later);
  };
  go_to(from, 0);
  while (!heap_.empty()) {
    poller_.add_work(kOfEntry);
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Entry top = heap_.back();
    heap_.pop_back();
    if (reached(to) && top.distance > kAsShort * distance_[to.index()]) return;
    const double here = distance_[top.vertex.index()];
    if (top.vertex == to || top.distance > here + landmarks_->bound(top.vertex)) continue;
    visit_neighbours(top.vertex, [&](VertexId v, double length) {
      const bool closed_way =
          (v != to && blocked(v)) || (not_along_edge && top.vertex == from && v == to);
      if (!closed_way) go_to(v, here + length);
    });
  }
}

/// Sets the parents along the path back from `to`: the smallest predecessor on a shortest path.
/// False if the length of an edge vanishes beside the distance, since the order of the search in
/// search_around() then decides.
bool EdgeDijkstra::find_parents(VertexId from, VertexId to, bool not_along_edge) {
  for (VertexId v = to; v != from; v = parent_[v.index()]) {
    const double distance = distance_[v.index()];
    VertexId parent;
    bool without_length = false;
    visit_neighbours(v, [&](VertexId u, double length) {
      if (!reached(u) || u == to || (not_along_edge && v == to && u == from)) return;
      if (distance_[u.index()] + length != distance) return;
      without_length = without_length || !(distance_[u.index()] < distance);
      if (!parent.valid() || u < parent) parent = u;
    });
    if (without_length || !parent.valid()) return false;
    parent_[v.index()] = parent;
  }
  return true;
}

/// Records a path to an unsettled vertex, and appends it to the heap if it is shorter than before.
void EdgeDijkstra::reach(VertexId vertex, VertexId from, double distance) {
  const std::size_t v = vertex.index();
  if (reached(vertex) && distance >= distance_[v]) {
    if (distance == distance_[v] && from < parent_[v]) parent_[v] = from;
    return;
  }
  reach_stamp_[v] = search_;
  distance_[v] = distance;
  parent_[v] = from;
  heap_.push_back({distance, vertex});
}

void EdgeDijkstra::no_path(std::size_t leg, VertexId from, VertexId to) {
  const std::string name =
      "Leg " + std::to_string(leg) + " from vertex " + text(from) + " to vertex " + text(to);
  if (search(from, to, false, /*obey_blocks=*/false)) {
    throw Error(ErrorCode::kBadCurve,
                name + " has no path: the rest of the drawing is in its way everywhere.");
  }
  throw Error(ErrorCode::kBadCurve,
              name + " has no path: its ends lie on different components of the mesh.");
}

std::vector<VertexId> draw_edge_path(const Surface& surface, std::span<const VertexId> through,
                                     bool closed) {
  return EdgeDijkstra(surface).draw(through, closed);
}

}  // namespace talweg
