// Landmarks are vertices with known distances along edges to all other vertices.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Lower bounds of distances along edges, by the triangle inequality (Goldberg & Harrelson, SODA
/// 2005): two vertices are at least as far apart as their distances from any landmark differ.
class EdgeLandmarks {
 public:
  /// Chooses landmarks in the component of `inside`: each is the vertex farthest from the landmarks
  /// chosen before. O(n log n) for n vertices, 32 bytes for each. Throws Cancelled.
  EdgeLandmarks(const Surface& surface, VertexId inside, ProgressPoller& poller);

  /// Makes the point behind the `ends` of paths the goal.
  void aim(std::span<const PathEnd> ends);
  /// A lower bound of the distance from the vertex to the goal, mesh units; 0 in other components.
  [[nodiscard]] double bound(VertexId vertex) const;

 private:
  static constexpr std::size_t kCount = 8;
  using Distances = std::array<float, kCount>;  ///< infinite in other components

  std::vector<Distances> of_vertex_;
  // A path from a vertex v to an end t is at least as long as the distances of t and v from a
  // landmark differ. The minimum over all ends, each with its way beyond, needs two numbers.
  Distances goal_from_ = {};  ///< least of distance(t) + beyond: the length of the path to the goal
  Distances goal_to_ = {};    ///< largest of distance(t) - beyond, at least 0
};

}  // namespace talweg
