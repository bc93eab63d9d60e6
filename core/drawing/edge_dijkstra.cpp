#include "talweg/core/drawing/edge_dijkstra.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "talweg/core/drawing/edge_landmarks.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

constexpr std::size_t kOfEntry = 8;  // units of work

std::string text(VertexId v) { return std::to_string(v.index()); }

/// The way beyond a vertex that is one of `ends`; infinite if the vertex is none of them.
double beyond(std::span<const PathEnd> ends, VertexId vertex) {
  double least = HUGE_VAL;
  for (const PathEnd& end : ends) {
    if (end.vertex == vertex) least = std::min(least, end.beyond);
  }
  return least;
}

/// The end of the shortest path so far, and its length with the way beyond. Of equally long paths,
/// the path to the smallest vertex counts.
struct Shortest {
  VertexId end;
  double length = HUGE_VAL;

  void add(VertexId vertex, double with_beyond) {
    if (with_beyond > length || std::isinf(with_beyond)) return;
    if (with_beyond == length && end < vertex) return;
    end = vertex;
    length = with_beyond;
  }
};

double least_beyond(std::span<const PathEnd> ends) {
  double least = HUGE_VAL;
  for (const PathEnd& end : ends) least = std::min(least, end.beyond);
  return least;
}

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
                                            std::to_string(surface_->vertex_count()) +
                                            " vertices, counted from 0.");
    }
  }
  std::vector<VertexId> sorted(through.begin(), through.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    throw Error(ErrorCode::kBadCurve, "Vertex " + text(*twice) + " is a way-point twice.");
  }
}

std::vector<VertexId> EdgeDijkstra::between(std::span<const PathEnd> starts,
                                            std::span<const PathEnd> ends,
                                            const Progress& progress) {
  poller_ = ProgressPoller(progress, "draw");
  ++drawing_;
  const VertexId end = search({starts, ends});
  if (!end.valid()) {
    throw Error(ErrorCode::kBadCurve,
                "No path joins the points near vertices " + text(starts.front().vertex) + " and " +
                    text(ends.front().vertex) + ": they lie on different components of the mesh.");
  }
  return path_to(end);
}

bool EdgeDijkstra::append_leg(VertexId from, VertexId to, bool not_along_edge,
                              std::vector<VertexId>& path) {
  const PathEnd start{from}, end{to};
  if (!search({{&start, 1}, {&end, 1}, not_along_edge}).valid()) return false;
  const std::vector<VertexId> leg = path_to(to);
  path.insert(path.end(), leg.begin() + 1, leg.end());
  return true;
}

/// The path that the last search found to a vertex.
std::vector<VertexId> EdgeDijkstra::path_to(VertexId end) const {
  std::vector<VertexId> path;
  for (VertexId v = end; v.valid(); v = parent_[v.index()]) path.push_back(v);
  std::reverse(path.begin(), path.end());
  return path;
}

VertexId EdgeDijkstra::search(const Task& task) {
  constexpr std::size_t kPatience = 16;  // searches of the whole mesh; landmarks cost nine
  if (!landmarks_ && looked_at_ > kPatience * surface_->vertex_count()) {
    landmarks_ = std::make_unique<EdgeLandmarks>(*surface_, task.starts.front().vertex, poller_);
  }
  if (landmarks_ && task.obey_blocks) {
    const VertexId end = search_with_landmarks(task);
    if (!end.valid() || find_parents(task, end)) return end;
  }
  return search_around(task);
}

/// Calls `visit` with each neighbour and the length of the edge to it.
template <class Visit>
void EdgeDijkstra::visit_neighbours(VertexId vertex, const Visit& visit) const {
  for_each_spoke(*surface_, vertex,
                 [&](HalfedgeId h) { visit(surface_->head(h), surface_->length(edge_of(h))); });
}

/// True if no path may use the edge between two neighbours.
bool EdgeDijkstra::closed_way(const Task& task, VertexId from, VertexId to) const {
  if (task.obey_blocks && blocked(to) && std::isinf(beyond(task.ends, to))) return true;
  return task.not_along_edge && std::isfinite(beyond(task.starts, from)) &&
         std::isfinite(beyond(task.ends, to));
}

VertexId EdgeDijkstra::search_around(const Task& task) {
  ++search_;
  heap_.clear();
  for (const PathEnd& start : task.starts) reach(start.vertex, VertexId{}, start.beyond);
  std::make_heap(heap_.begin(), heap_.end(), later);
  Shortest best;
  const double least = least_beyond(task.ends);
  while (!heap_.empty()) {
    poller_.add_work(kOfEntry);
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Entry top = heap_.back();
    heap_.pop_back();
    if (settled_stamp_[top.vertex.index()] == search_) continue;
    settled_stamp_[top.vertex.index()] = search_;
    ++looked_at_;
    if (top.distance + least > best.length) break;
    best.add(top.vertex, top.distance + beyond(task.ends, top.vertex));
    visit_neighbours(top.vertex, [&](VertexId v, double length) {
      if (settled_stamp_[v.index()] == search_ || closed_way(task, top.vertex, v)) return;
      const std::size_t size = heap_.size();
      reach(v, top.vertex, top.distance + length);
      if (heap_.size() > size) std::push_heap(heap_.begin(), heap_.end(), later);
    });
  }
  return best.end;
}

/// A* search. The distances of all vertices on shortest paths are those of search_around(): a
/// vertex is visited again when a shorter path to it is found, and the search ends only when no
/// other path can be as short, up to rounding.
VertexId EdgeDijkstra::search_with_landmarks(const Task& task) {
  constexpr double kAsShort = 1 + 1e-9;
  ++search_;
  heap_.clear();
  landmarks_->aim(task.ends);
  Shortest best;
  const auto go_to = [&](VertexId v, double distance) {
    if (reached(v) && distance >= distance_[v.index()]) return;
    reach_stamp_[v.index()] = search_;
    distance_[v.index()] = distance;
    heap_.push_back({distance + landmarks_->bound(v), v});
    std::push_heap(heap_.begin(), heap_.end(), later);
    best.add(v, distance + beyond(task.ends, v));
  };
  for (const PathEnd& start : task.starts) go_to(start.vertex, start.beyond);
  while (!heap_.empty()) {
    poller_.add_work(kOfEntry);
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Entry top = heap_.back();
    heap_.pop_back();
    if (top.distance > kAsShort * best.length) break;
    const double here = distance_[top.vertex.index()];
    if (here >= best.length || top.distance > here + landmarks_->bound(top.vertex)) continue;
    visit_neighbours(top.vertex, [&](VertexId v, double length) {
      if (!closed_way(task, top.vertex, v)) go_to(v, here + length);
    });
  }
  return best.end;
}

/// Sets the parents along the path back from `end`: the smallest predecessor on a shortest path.
/// False if the length of an edge vanishes beside the distance, since the order of the search in
/// search_around() then decides.
bool EdgeDijkstra::find_parents(const Task& task, VertexId end) {
  VertexId v = end;
  while (distance_[v.index()] < beyond(task.starts, v)) {
    const double distance = distance_[v.index()];
    VertexId parent;
    bool without_length = false;
    visit_neighbours(v, [&](VertexId u, double length) {
      if (!reached(u) || closed_way(task, u, v)) return;
      if (distance_[u.index()] + length != distance) return;
      without_length = without_length || !(distance_[u.index()] < distance);
      if (!parent.valid() || u < parent) parent = u;
    });
    if (without_length || !parent.valid()) return false;
    parent_[v.index()] = parent;
    v = parent;
  }
  parent_[v.index()] = {};
  return true;
}

/// Records a path to an unsettled vertex, and appends it to the heap if it is shorter than before.
void EdgeDijkstra::reach(VertexId vertex, VertexId from, double distance) {
  const std::size_t v = vertex.index();
  if (reached(vertex) && distance >= distance_[v]) {
    if (distance == distance_[v] && parent_[v].valid() && from < parent_[v]) parent_[v] = from;
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
  const PathEnd start{from}, end{to};
  if (search({{&start, 1}, {&end, 1}, false, /*obey_blocks=*/false}).valid()) {
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
