// A leg start is the curve from which fairing starts, with legs that were straightened without a
// lift.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/fairing/leg_tension.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The curve that consists of the legs of `straight` and the strokes of `strokes`, which pass the
/// same fixed points; `strokes` where they do not. All functions here are O(points); on a loop that
/// passes its first fixed point several times, O(points) for each passage that is tried as the
/// beginning.
SurfaceCurve with_legs(const DrawnLegs& legs, const SurfaceCurve& strokes,
                       const SurfaceCurve& straight);

/// The stretches of a curve between the fixed points; none where the curve does not pass all of
/// them.
std::vector<SurfaceCurve> stretches_of(const DrawnLegs& legs, const SurfaceCurve& curve);

/// The strokes of a curve, that is, its stretches that are not legs; the whole curve where it has
/// no legs, or does not pass the fixed points.
std::vector<SurfaceCurve> strokes_of(const DrawnLegs& legs, const SurfaceCurve& curve);

/// Per point of the curve: whether the point lies on a stroke, ends included.
std::vector<bool> on_strokes(const DrawnLegs& legs, const SurfaceCurve& curve);

/// The legs and fixed points of the curve from which fairing starts.
struct LegStart {
  LegTension tension;
  std::vector<std::size_t> fixed;  ///< indices of curve points, ascending
};
/// The legs of a curve in the curve's own order; none where the curve does not pass the fixed
/// points in their order. `length_exponent`: see LegTension.
std::optional<LegStart> start_on(const DrawnLegs& legs, const SurfaceCurve& curve,
                                 double length_exponent);

/// Per point of a curve: the number of the stretch that contains the point, or begins there. Empty
/// where the curve does not pass the fixed points in their order.
std::vector<std::size_t> stretches_along(const std::vector<SurfacePoint>& fixed,
                                         const SurfaceCurve& curve);

/// The start of the reversed curve, for an open curve of `points` points.
LegStart reversed(LegStart start, std::size_t points);
/// Appends the start of the next curve to `start`, whose curve ends at its point `last`, where the
/// next curve begins.
void append(const LegStart& next, std::size_t last, LegStart& start);

}  // namespace talweg
