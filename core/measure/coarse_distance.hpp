// The coarse distance to curves is measured along edges: a cheap upper bound of the distance.
#pragma once

#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Upper bounds of distances along the surface: lengths of shortest ways that cross one face at the
/// beginning and at the end, and follow edges between. Dijkstra's algorithm spreads from the curves
/// as far as queries need: O(m log m) for m edges nearer than the results, and memory for all
/// vertices. The surface must outlive the object.
class CoarseDistance {
 public:
  /// Throws Error(kBadCurve) as pieces_of() does.
  CoarseDistance(const Surface& surface, std::span<const SurfaceCurve> curves);

  /// Bounds for a segment; infinite if no curve can be reached.
  struct OnSegment {
    double first = 0, last = 0;  ///< bounds of the distances at the ends, mesh units
    double most = 0;             ///< bound of all distances on the segment
  };
  [[nodiscard]] OnSegment on(const CurveSegment& segment);

 private:
  using Way = std::pair<double, VertexId>;  // the length of a way to the vertex

  void reach(VertexId vertex, double way);
  void start_at(const PolylinePiece& piece);
  double at_vertex(VertexId vertex);

  const Surface* surface_;
  PolylinePieces pieces_;
  std::vector<double> ways_;  // per vertex, the shortest length so far
  std::priority_queue<Way, std::vector<Way>, std::greater<>> queue_;
};

}  // namespace talweg
