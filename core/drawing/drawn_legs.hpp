// Drawn legs are the stretches of a curve between way-points, where the drawing is no stroke.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/drawing/way_point.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The points of one curve that stay, and what lies between them.
struct DrawnLegs {
  std::vector<SurfacePoint> fixed;  ///< pins and way-points in the curve's order; both of its ends
  std::vector<double> tolerances;   ///< of these, mesh units; 0 for those that are no way-points
  std::vector<bool> is_leg;         ///< per stretch from one to the next

  [[nodiscard]] bool any() const;
  [[nodiscard]] bool all() const;  ///< of at least one
};

/// Between two way-points there is a leg, unless a painted point lies there. A loop with fewer than
/// three way-points has no legs: nothing would hold it open. O(points of all kinds), those of other
/// curves too: for all curves their number times the way-points and painted points of all.
DrawnLegs legs_of(const SurfaceCurve& curve, std::span<const SurfacePoint> pins,
                  std::span<const WayPoint> way_points, std::span<const SurfacePoint> painted);

}  // namespace talweg
