// A dragged point is one way-point of a drawing that a hand moves.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::benchmarks {

/// A drawing along mesh edges with a way-point every `leg` vertices, and another vertex a few edges
/// aside to which one of the way-points, in the middle, is dragged.
class DraggedPoint {
 public:
  DraggedPoint(const SurfaceMesh& mesh, const SurfaceCurve& drawn, std::size_t leg);
  /// With way-points at these points of the drawing, one of which is dragged so many edges aside.
  DraggedPoint(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
               const std::vector<std::size_t>& points, int aside);

  /// The drawing after the drag: its two legs drawn anew.
  SurfaceCurve redraw(EdgeDijkstra& dijkstra) const;
  /// The way-points after the drag.
  const std::vector<VertexId>& through() const { return through_; }

 private:
  const SurfaceMesh* mesh_;
  bool closed_;
  std::vector<VertexId> path_, through_;
  std::size_t moved_ = 0;
};

}  // namespace talweg::benchmarks
