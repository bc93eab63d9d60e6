// A bounded deviation has upper and lower bounds, because the budget ended the exact measurement.
#pragma once

#include <cmath>
#include <span>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Results of a measurement for one segment; mesh units.
struct KnownSegment {
  double first = HUGE_VAL, middle = HUGE_VAL, last = HUGE_VAL;  ///< exact distances, or infinite
  double most = HUGE_VAL;                                       ///< upper bound over the segment
};

/// Bounds of the deviation. Upper bounds come from `known`, the results for the first segments, and
/// from CoarseDistance; lower bounds from exact distances and distances through space. `segments`
/// are the segments of `from`, `largest` is the largest exact distance found. More results never
/// make a bound worse. O(n log n) for n points, plus the cost of CoarseDistance.
OneSidedSurfaceDeviation bounded_deviation(const SurfaceMesh& mesh,
                                           std::span<const SurfaceCurve> from,
                                           std::span<const CurveSegment> segments,
                                           std::span<const SurfaceCurve> others,
                                           std::span<const KnownSegment> known, double largest);

}  // namespace talweg
