// Legs start straight: they are straightened without a lift, and fairing starts from there.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/fairing/leg_tension.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The legs of a curve and the strokes of another, which pass the same fixed points; the latter
/// curve where they do not. All functions here are O(points); worse: for a loop as often as it
/// passes its first fixed point without the others in order.
SurfaceCurve with_legs(const DrawnLegs& legs, const SurfaceCurve& strokes,
                       const SurfaceCurve& straight);

/// The stretches of a curve between the fixed points; none where it does not pass these.
std::vector<SurfaceCurve> stretches_of(const DrawnLegs& legs, const SurfaceCurve& curve);

/// The stretches of a curve that are no legs; the whole curve where it has no legs, or does not
/// pass the fixed points.
std::vector<SurfaceCurve> strokes_of(const DrawnLegs& legs, const SurfaceCurve& curve);

/// Per point of the curve: whether it lies on a stroke, or at the end of one.
std::vector<bool> on_strokes(const DrawnLegs& legs, const SurfaceCurve& curve);

/// A curve that passes the fixed points, as fairing starts from it.
struct LegStart {
  LegTension tension;
  std::vector<std::size_t> fixed;  ///< indices of its points, ascending
};
/// None where the curve does not pass the fixed points in their order.
std::optional<LegStart> start_on(const DrawnLegs& legs, const SurfaceCurve& curve, double relative);

/// Per point of a curve that passes fixed points in their order: the stretch it lies on, or begins.
/// Empty where it does not pass them.
std::vector<std::size_t> stretches_along(const std::vector<SurfacePoint>& fixed,
                                         const SurfaceCurve& curve);

/// The same for the open curve of `points` points in the other direction.
LegStart reversed(LegStart start, std::size_t points);
/// Appends that of the next curve to one that ends at point `last`, where the next one begins.
void append(const LegStart& next, std::size_t last, LegStart& start);

}  // namespace talweg
