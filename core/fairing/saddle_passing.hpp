// A curve that bends at a saddle vertex passes it on one side instead.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/fairing/near_points.hpp"
#include "talweg/intrinsic/lines/strip_line.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Moves curves off saddle vertices. At a vertex a curve turns by half the difference of the angles
/// on both sides, though it may be straight on one of them.
class SaddlePassing {
 public:
  explicit SaddlePassing(const Surface& surface) : surface_(&surface), lines_(surface) {}

  /// The curve of these points, led past the saddle vertices at which it need not stay. Its
  /// points and the next share a face, as they do before. The ends of an open curve stay. O(points
  /// + degrees of the vertices that it passes).
  SurfaceCurve led_past(const std::vector<KeptPoint>& points, bool closed);

 private:
  /// What takes the place of a point at a vertex: points beside it, 1/100 as far from it as the
  /// nearer neighbour, on the side on which the curve turns less. The point itself where that
  /// is no gain, where it would be a kink of more than 3.5 degrees and of more than half, or at the
  /// boundary.
  std::vector<SurfacePoint> beside(const SurfacePoint& before, VertexId vertex,
                                   const SurfacePoint& after);

  /// The faces around the vertex on one side, from one neighbour to the other.
  struct Side {
    FaceStrip strip;
    std::vector<double> angles;  ///< from the first neighbour to each crossing
    double sweep = 0;            ///< to the other one
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
