// A vertex filter tells what of a mesh is finer than a scale.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Vertices of a surface and, for each, its neighbours among them.
class VertexGraph {
 public:
  /// All vertices of the surface. O(vertices + edges).
  explicit VertexGraph(const Surface& surface);
  /// The vertices that so many edges lead to from one of the seeds, which come first, each once.
  /// O(vertices of the surface) for one list of numbers, else O(vertices of the graph).
  VertexGraph(const Surface& surface, std::span<const VertexId> seeds, int rings);

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] VertexId vertex(std::size_t i) const { return vertices_[i]; }
  [[nodiscard]] std::span<const std::uint32_t> neighbours(std::size_t i) const {
    return std::span(neighbours_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  /// Whether all neighbours that the vertex has on the surface are in the graph.
  [[nodiscard]] bool is_whole(std::size_t i) const { return whole_[i] != 0; }

 private:
  void connect(const Surface& surface, std::span<const std::uint32_t> number_of);

  std::vector<VertexId> vertices_;
  std::vector<std::uint32_t> begin_, neighbours_;
  std::vector<std::uint8_t> whole_;
};

/// What each vertex has that is finer than a scale s, in edges: (1 − exp(−0.61 s² L))² p, with L p
/// = p minus the mean of its neighbours. That is what a diffusion takes away, and does again with
/// what it took away (Tukey's twicing): a wave 2π s / √8 edges long is halved, and of longer ones
/// goes the fourth power of their frequency, so that bent surfaces do not shrink. The exponential
/// is a Chebyshev polynomial of degree 3 s + 2 in L, which is exact to 0.003 for scales up to 6.
/// One result for each scale; at vertices that are not whole there is no L p. O(degree · graph).
/// Throws Cancelled.
std::vector<std::vector<Point>> finer_parts(const VertexGraph& graph,
                                            std::span<const Point> positions,
                                            std::span<const double> scales, ProgressPoller& poller);

/// Replaces each value by the mean of its surroundings, about three edges wide. O(16 · graph).
/// Throws Cancelled.
void spread(const VertexGraph& graph, std::vector<double>& values, ProgressPoller& poller);

}  // namespace talweg
