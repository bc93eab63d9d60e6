#include "talweg/core/lifting/touched_edges.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

constexpr std::size_t kOfVertex = 16;  // units of work

/// The touched vertices and their neighbours, sorted, with the length of the shortest path along
/// edges from the curves to each.
class EdgePaths {
 public:
  EdgePaths(const Surface& surface, std::span<const VertexId> touched, ProgressPoller& poller)
      : surface_(surface), poller_(poller) {
    for (const VertexId v : touched) {
      if (v.index() >= surface.vertex_count()) continue;
      poller_.add_work(kOfVertex);
      vertices_.push_back(v);
      for_each_spoke(surface, v, [&](HalfedgeId h) { vertices_.push_back(surface.head(h)); });
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    lengths_.assign(vertices_.size(), HUGE_VAL);
  }

  void offer(VertexId v, double length) {
    const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), v);
    if (found == vertices_.end() || *found != v) return;
    const auto i = static_cast<std::size_t>(found - vertices_.begin());
    if (!(length < lengths_[i])) return;
    lengths_[i] = length;
    queue_.emplace(length, i);
  }

  /// The largest path length, after all sources have been offered; infinite if a vertex is not
  /// reached.
  double farthest() {
    std::size_t settled = 0;
    double last = 0;
    while (!queue_.empty()) {
      const auto [length, i] = queue_.top();
      queue_.pop();
      if (length > lengths_[i]) continue;
      poller_.add_work(kOfVertex);
      ++settled;
      last = length;
      for_each_spoke(surface_, vertices_[i], [&, from = length](HalfedgeId h) {
        offer(surface_.head(h), from + surface_.length(edge_of(h)));
      });
    }
    return settled == vertices_.size() ? last : HUGE_VAL;
  }

  [[nodiscard]] double shortest() const {
    double shortest = HUGE_VAL;
    for (const VertexId v : vertices_) {
      for_each_spoke(surface_, v, [&](HalfedgeId h) {
        shortest = std::min(shortest, surface_.length(edge_of(h)));
      });
    }
    return shortest;
  }

 private:
  using Item = std::pair<double, std::size_t>;

  const Surface& surface_;
  ProgressPoller& poller_;
  std::vector<VertexId> vertices_;
  std::vector<double> lengths_;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue_;
};

}  // namespace

TouchedEdges touched_edges(const Surface& surface, std::span<const VertexId> touched,
                           std::span<const SurfaceCurve> curves, const Progress& progress) {
  ProgressPoller poller(progress, "straighten");
  EdgePaths paths(surface, touched, poller);
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      poller.add_work(kOfVertex);
      const FaceCoordinates at = coordinates_in(surface, point, any_face(surface, point));
      const auto corners = surface.corners(at.face);
      for (std::size_t k = 0; k < 3; ++k) {
        FaceCoordinates corner = at;
        corner.barycentric = {0, 0, 0};
        corner.barycentric[k] = 1;
        paths.offer(corners[k], distance_in_face(surface, at, corner));
      }
    }
  }
  const double farthest = paths.farthest();
  return {farthest, paths.shortest()};
}

}  // namespace talweg
