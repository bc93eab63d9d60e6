// Drawn legs are the stretches of a curve between way-points where nothing was painted.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/drawing/way_point.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The points of one curve that stay, and the kinds of the stretches between them.
struct DrawnLegs {
  std::vector<SurfacePoint> fixed;  ///< pins, way-points and both ends, in order
  std::vector<double> tolerances;  ///< of `fixed`, mesh units; 0 for points that are not way-points
  std::vector<bool> is_leg;        ///< per stretch from one fixed point to the next

  [[nodiscard]] bool any() const;
  [[nodiscard]] bool all() const;  ///< whether there are stretches, and all are legs
};

/// The stretch between two way-points is a leg, unless a painted point lies on it. A loop with
/// fewer than three way-points has no legs, because nothing would hold it open. O(points, pins,
/// way-points and painted points, those of other curves included); so for all curves, the cost is
/// their number times the way-points and painted points of all.
DrawnLegs legs_of(const SurfaceCurve& curve, std::span<const SurfacePoint> pins,
                  std::span<const WayPoint> way_points, std::span<const SurfacePoint> painted);

}  // namespace talweg
