// The coarse distance to curves is that along edges: never less than the distance, and cheap.
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

/// Upper bounds for distances along the surface: the shortest ways that follow edges, but for their
/// beginning and end, which cross one face. Spreads from the curves by Dijkstra's algorithm, as far
/// as it is asked: O(m log m) for m edges nearer than the answers, and memory for all vertices. The
/// surface must outlive the object.
class CoarseDistance {
 public:
  /// Throws Error(kBadCurve) as pieces_of() does.
  CoarseDistance(const Surface& surface, std::span<const SurfaceCurve> curves);

  /// Bounds for a segment; infinite where no curve can be reached.
  struct OnSegment {
    double first = 0, last = 0;  ///< of the distances at its ends, mesh units
    double most = 0;             ///< of all distances on it
  };
  [[nodiscard]] OnSegment on(const CurveSegment& segment);

 private:
  using Way = std::pair<double, VertexId>;  // the way's length, to this vertex

  void reach(VertexId vertex, double way);
  void start_at(const PolylinePiece& piece);
  double at_vertex(VertexId vertex);

  const Surface* surface_;
  PolylinePieces pieces_;
  std::vector<double> ways_;  // per vertex, the shortest so far
  std::priority_queue<Way, std::vector<Way>, std::greater<>> queue_;
};

}  // namespace talweg
