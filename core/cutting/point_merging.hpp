// Point merging makes one point of those that lie too near to each other to be two.
#pragma once

#include <array>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Tells which points of a cut are one. O(1) for a point.
class PointMerging {
 public:
  /// `merge`: a part of an edge, in barycentrics; `resolution`: a distance, 0 for none. The surface
  /// must outlive this.
  PointMerging(const Surface& surface, double merge, double resolution)
      : surface_(surface), merge_(merge), resolution_(resolution) {}

  /// How near, as a part of this edge.
  [[nodiscard]] double on(EdgeId edge) const { return at_least(surface_.length(edge)); }
  /// How near, in barycentrics, two points of one face must be at least to be one.
  [[nodiscard]] std::array<double, 3> in(FaceId face) const;
  /// Whether two points of one face are one.
  [[nodiscard]] bool same(const InFace& p, const InFace& q) const;
  /// Moves a point to a vertex or an edge if it lies near it.
  [[nodiscard]] SurfacePoint settled(const SurfacePoint& point) const;

 private:
  [[nodiscard]] double at_least(double size) const;

  const Surface& surface_;
  double merge_;
  double resolution_;
};

}  // namespace talweg
