// A vertex filter separates the parts of vertex positions that are finer than a scale.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A set of vertices of a surface, with the neighbours of each inside the set.
class VertexGraph {
 public:
  /// All vertices of the surface. O(vertices + edges).
  explicit VertexGraph(const Surface& surface);
  /// The vertices at most `rings` edges from a seed; the seeds come first, without repeats.
  /// O(vertices of the graph), and one array over all vertices of the surface.
  VertexGraph(const Surface& surface, std::span<const VertexId> seeds, int rings);

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] VertexId vertex(std::size_t i) const { return vertices_[i]; }
  [[nodiscard]] std::span<const std::uint32_t> neighbours(std::size_t i) const {
    return std::span(neighbours_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  /// Whether all neighbours of the vertex on the surface are in the graph.
  [[nodiscard]] bool is_whole(std::size_t i) const { return whole_[i] != 0; }

 private:
  void connect(const Surface& surface, std::span<const std::uint32_t> number_of);

  std::vector<VertexId> vertices_;
  std::vector<std::uint32_t> begin_, neighbours_;
  std::vector<std::uint8_t> whole_;
};

/// The part of each position that is finer than a scale s, in edges: (1 − exp(−0.61 s² L))² p,
/// where L p is p minus the mean of its neighbours. This is the residual of diffusion with Tukey's
/// twicing (the residual of a diffusion is diffused once more and added back). A wave of 2π s / √8
/// edges is halved; of longer waves the removed part decreases with the fourth power of the
/// frequency, so curved surfaces do not shrink. A Chebyshev polynomial in L of degree 3 s + 2 for
/// the largest scale (at most 20) approximates the filter, with an error of at most 0.003 for
/// scales up to 6. One list of parts per scale. L p is 0 at vertices that are not whole. O(degree ·
/// graph). Throws Cancelled.
std::vector<std::vector<Point>> finer_parts(const VertexGraph& graph,
                                            std::span<const Point> positions,
                                            std::span<const double> scales, ProgressPoller& poller);

/// Replaces each value by a mean over its surroundings, about three edges wide, by 16 steps of
/// averaging. O(16 · graph). Throws Cancelled.
void spread(const VertexGraph& graph, std::vector<double>& values, ProgressPoller& poller);

}  // namespace talweg
