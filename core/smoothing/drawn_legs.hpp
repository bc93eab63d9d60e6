// Drawn legs are the stretches of a curve between way-points, where the drawing is no stroke.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/fairing/leg_tension.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
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

/// A loop with fewer than three way-points has no legs: nothing would hold it open.
DrawnLegs legs_of(const SurfaceCurve& curve, const CurveOptions& options);

/// The legs of a curve and the strokes of another, which pass the same fixed points; the latter
/// curve where they do not.
SurfaceCurve with_legs(const DrawnLegs& legs, const SurfaceCurve& strokes,
                       const SurfaceCurve& straight);

/// A curve that passes the fixed points, as fairing starts from it.
struct LegStart {
  LegTension tension;
  std::vector<std::size_t> fixed;  ///< indices of its points, ascending
};
/// None where the curve does not pass the fixed points in their order.
std::optional<LegStart> start_on(const DrawnLegs& legs, const SurfaceCurve& curve, double relative);

}  // namespace talweg
