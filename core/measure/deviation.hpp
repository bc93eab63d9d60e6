// The deviation of two curves is their largest and mean distance in space.
#pragma once

#include <span>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Distances of the points of one curve to another.
struct OneSidedDeviation {
  double max = 0;            ///< mesh units
  double mean = 0;           ///< mesh units: averaged over the length of the first curve
  Point at = Point::Zero();  ///< the point of the first curve at the largest distance
};

/// Distances in both directions. Both are needed: a result that cuts a corner stays near the
/// drawing, but the drawing's corner lies far from the result.
struct Deviation {
  OneSidedDeviation to_drawn;    ///< of the result's points to the drawing
  OneSidedDeviation from_drawn;  ///< of the drawing's points to the result
  Point at = Point::Zero();      ///< the point at the larger of both maxima
};

/// Distances of all points of the segments `from`, not only of their ends, to the nearest points of
/// `to`. The distances are Euclidean, so never longer than along the surface.
///
/// `max` is at most the true maximum, and at least the true maximum divided by 1 + 1e-6 (apart from
/// a few ulp of the coordinates). Along a segment, the distance to a single segment of `to` is
/// convex, hence bounded by its values at the two ends. Intervals are halved until the bound
/// excludes a larger maximum. `mean` is integrated by adaptive Simpson's rule to about 1e-4
/// relative. O((m + n) log n) for m and n segments, unless most distances are ties. Throws
/// Error(kBadCurve) if `from` is empty or has a coordinate that is not finite; Cancelled (stage
/// "measure").
OneSidedDeviation one_sided_deviation(std::span<const Segment> from, const NearestSegment& to,
                                      const Progress& progress = {});

/// Both one-sided deviations of two polylines. A closed polyline does not repeat its first point.
Deviation deviation(std::span<const Point> result, bool result_closed, std::span<const Point> drawn,
                    bool drawn_closed, const Progress& progress = {});

}  // namespace talweg
