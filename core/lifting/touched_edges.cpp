#include "talweg/core/lifting/touched_edges.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace talweg {
namespace {

constexpr std::size_t kOfVertex = 16;  // units of work

/// Calls visit(h) for every halfedge h that leaves v.
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

/// The touched vertices and their neighbours, sorted, with the length of the shortest path along
/// edges from the curves to each.
class Ways {
 public:
  Ways(const Surface& surface, std::span<const VertexId> touched, Asker& asker)
      : surface_(surface), asker_(asker) {
    for (const VertexId v : touched) {
      if (v.index() >= surface.vertex_count()) continue;
      asker_.did(kOfVertex);
      vertices_.push_back(v);
      for_each_spoke(surface, v, [&](HalfedgeId h) { vertices_.push_back(surface.head(h)); });
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    ways_.assign(vertices_.size(), HUGE_VAL);
  }

  void offer(VertexId v, double way) {
    const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), v);
    if (found == vertices_.end() || *found != v) return;
    const auto i = static_cast<std::size_t>(found - vertices_.begin());
    if (!(way < ways_[i])) return;
    ways_[i] = way;
    queue_.emplace(way, i);
  }

  /// The largest path length, after all sources have been offered; infinite if a vertex is not
  /// reached.
  double farthest() {
    std::size_t settled = 0;
    double last = 0;
    while (!queue_.empty()) {
      const auto [way, i] = queue_.top();
      queue_.pop();
      if (way > ways_[i]) continue;
      asker_.did(kOfVertex);
      ++settled;
      last = way;
      for_each_spoke(surface_, vertices_[i], [&, from = way](HalfedgeId h) {
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
  Asker& asker_;
  std::vector<VertexId> vertices_;
  std::vector<double> ways_;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue_;
};

}  // namespace

TouchedEdges touched_edges(const Surface& surface, std::span<const VertexId> touched,
                           std::span<const SurfaceCurve> curves, const Progress& progress) {
  Asker asker(progress, "straighten");
  Ways ways(surface, touched, asker);
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      asker.did(kOfVertex);
      const FaceCoordinates at = coordinates_in(surface, point, any_face(surface, point));
      const auto corners = surface.corners(at.face);
      for (std::size_t k = 0; k < 3; ++k) {
        FaceCoordinates corner = at;
        corner.barycentric = {0, 0, 0};
        corner.barycentric[k] = 1;
        ways.offer(corners[k], distance_in_face(surface, at, corner));
      }
    }
  }
  const double farthest = ways.farthest();
  return {farthest, ways.shortest()};
}

}  // namespace talweg
