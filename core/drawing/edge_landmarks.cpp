#include "talweg/core/drawing/edge_landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

/// The distances from one vertex along edges, mesh units; infinite where no path leads.
std::vector<double> distances_from(const Surface& surface, VertexId start, ProgressPoller& poller) {
  constexpr std::size_t kOfEntry = 8;  // units of work
  using Entry = std::pair<double, std::size_t>;
  std::vector<double> distances(surface.vertex_count(), HUGE_VAL);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distances[start.index()] = 0;
  queue.emplace(0, start.index());
  while (!queue.empty()) {
    poller.add_work(kOfEntry);
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for_each_spoke(surface, VertexId{v}, [&, way = distance](HalfedgeId h) {
      const std::size_t next = surface.head(h).index();
      const double to_next = way + surface.length(edge_of(h));
      if (!(to_next < distances[next])) return;
      distances[next] = to_next;
      queue.emplace(to_next, next);
    });
  }
  return distances;
}

VertexId farthest(const std::vector<double>& distances) {
  std::size_t best = 0;
  double most = -1;
  for (std::size_t v = 0; v < distances.size(); ++v) {
    if (!(distances[v] > most) || std::isinf(distances[v])) continue;
    most = distances[v];
    best = v;
  }
  return VertexId{best};
}

}  // namespace

EdgeLandmarks::EdgeLandmarks(const Surface& surface, VertexId inside, ProgressPoller& poller)
    : of_vertex_(surface.vertex_count()) {
  VertexId landmark = farthest(distances_from(surface, inside, poller));
  std::vector<double> nearest(surface.vertex_count(), HUGE_VAL);
  for (std::size_t k = 0; k < kCount; ++k) {
    const std::vector<double> distances = distances_from(surface, landmark, poller);
    for (std::size_t v = 0; v < distances.size(); ++v) {
      of_vertex_[v][k] = static_cast<float>(distances[v]);
      nearest[v] = std::min(nearest[v], distances[v]);
    }
    landmark = farthest(nearest);
  }
}

void EdgeLandmarks::aim(std::span<const PathEnd> ends) {
  goal_from_.fill(HUGE_VALF);
  goal_to_.fill(0);
  for (const PathEnd& end : ends) {
    const Distances& there = of_vertex_[end.vertex.index()];
    const auto beyond = static_cast<float>(end.beyond);
    for (std::size_t k = 0; k < kCount; ++k) {
      goal_from_[k] = std::min(goal_from_[k], there[k] + beyond);
      goal_to_[k] = std::max(goal_to_[k], there[k] - beyond);
    }
  }
}

double EdgeLandmarks::bound(VertexId vertex) const {
  constexpr float kRounding = 2 * std::numeric_limits<float>::epsilon();
  const Distances& here = of_vertex_[vertex.index()];
  float best = 0;
  for (std::size_t k = 0; k < kCount; ++k) {
    const float gap = std::max(goal_from_[k] - here[k], here[k] - goal_to_[k]) -
                      kRounding * (here[k] + goal_from_[k]);
    best = gap > best && std::isfinite(gap) ? gap : best;
  }
  return best;
}

}  // namespace talweg
