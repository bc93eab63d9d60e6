// The arc length gives points on a curve by their distance along the curve.
#pragma once

#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

/// A curve measured once, for access to any point on it. Surface and curve must outlive the object.
class ArcLength {
 public:
  /// Throws Error(kBadCurve) where two neighbours share no face.
  ArcLength(const Surface& surface, const SurfaceCurve& curve);

  [[nodiscard]] double length() const { return arcs_.back(); }  ///< mesh units
  /// The point at this arc length, clamped to [0, length()].
  [[nodiscard]] SurfacePoint at(double arc) const;

 private:
  [[nodiscard]] const SurfacePoint& point(std::size_t k) const {
    return curve_->points[k % curve_->points.size()];
  }

  const Surface* surface_;
  const SurfaceCurve* curve_;
  std::vector<double> arcs_;  // at each point; for a closed curve once more at its first point
};

}  // namespace talweg::plugins
