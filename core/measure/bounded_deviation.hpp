// A bounded deviation is what holds for a deviation whose measurement had no time to end.
#pragma once

#include <cmath>
#include <span>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// What a measurement has found out about one segment; mesh units.
struct KnownSegment {
  double first = HUGE_VAL, middle = HUGE_VAL, last = HUGE_VAL;  ///< exact where they are finite
  double most = HUGE_VAL;                                       ///< no distance on it is larger
};

/// The bounds that follow from what is known of the first segments and, for all of them, from
/// CoarseDistance and the distance through space. `segments` are those of `from`, `largest` the
/// largest exact distance found. More known segments and samples never make a bound worse.
/// O(n log n) for n points, and what CoarseDistance costs.
OneSidedSurfaceDeviation bounded_deviation(const SurfaceMesh& mesh,
                                           std::span<const SurfaceCurve> from,
                                           std::span<const CurveSegment> segments,
                                           std::span<const SurfaceCurve> others,
                                           std::span<const KnownSegment> known, double largest);

}  // namespace talweg
