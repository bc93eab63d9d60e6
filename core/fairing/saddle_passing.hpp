// Saddle passing moves a curve that bends at a saddle vertex to one side of the vertex.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/fairing/near_points.hpp"
#include "talweg/intrinsic/lines/strip_line.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Moves curves off saddle vertices. At a vertex a curve turns by half the difference of the angles
/// on both sides, although it may be straight on one side.
class SaddlePassing {
 public:
  explicit SaddlePassing(const Surface& surface) : surface_(&surface), lines_(surface) {}

  /// The curve through these points, moved off the saddle vertices at which it need not stay. Each
  /// point and the next share a face, as in `points`. The ends of an open curve stay. O(points +
  /// degrees of the passed vertices).
  SurfaceCurve moved_off_saddles(const std::vector<KeptPoint>& points, bool closed);

 private:
  /// The replacement of a point at a vertex: points beside the vertex, 1/100 as far from it as the
  /// nearer neighbour, on the side where the curve turns less. The point itself at the boundary,
  /// where the turn does not decrease by more than half a degree, and where the new turn
  /// exceeds 3.5 degrees and half the old turn.
  std::vector<SurfacePoint> beside(const SurfacePoint& before, VertexId vertex,
                                   const SurfacePoint& after);

  /// The faces around the vertex on one side, from one neighbour to the other.
  struct Side {
    FaceStrip strip;
    std::vector<double> angles;  ///< from the first neighbour to each crossing
    double sweep = 0;            ///< from the first neighbour to the other
    bool ccw = false;
  };
  [[nodiscard]] Side side(const FaceCoordinates& from, const FaceCoordinates& to, VertexId vertex,
                          bool ccw) const;
  [[nodiscard]] FaceCoordinates in_middle(const Side& side, const FaceCoordinates& from,
                                          VertexId vertex, double aside, std::size_t& before) const;
  bool add_line(const FaceCoordinates& from, const FaceCoordinates& to, FaceStrip strip,
                std::vector<SurfacePoint>& points);

  const Surface* surface_;
  StripLines lines_;
};

}  // namespace talweg
