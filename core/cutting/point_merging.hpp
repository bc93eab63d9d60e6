// Point merging finds points of a cut that lie too near to each other, to a vertex or to an edge to
// stay separate.
#pragma once

#include <array>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The rules of merging. O(1) for a point.
class PointMerging {
 public:
  /// `merge`: a fraction of an edge, in barycentric coordinates; `resolution`: a distance, mesh
  /// units, 0 for none. The surface must outlive the object.
  PointMerging(const Surface& surface, double merge, double resolution)
      : surface_(surface), merge_(merge), resolution_(resolution) {}

  /// The merging distance on an edge, as a fraction of the edge.
  [[nodiscard]] double on(EdgeId edge) const { return at_least(surface_.length(edge)); }
  /// The merging distances in a face, in barycentric coordinates.
  [[nodiscard]] std::array<double, 3> in(FaceId face) const;
  /// Whether two points of one face are merged.
  [[nodiscard]] bool same(const InFace& p, const InFace& q) const;
  /// The point, moved to a vertex or an edge within the merging distance.
  [[nodiscard]] SurfacePoint settled(const SurfacePoint& point) const;

 private:
  [[nodiscard]] double at_least(double size) const;

  const Surface& surface_;
  double merge_;
  double resolution_;
};

}  // namespace talweg
