// A bound on the deviation replaces tau and slack: the smoothest curve within the bound is searched
// for.
#pragma once

#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {

/// Searches for the smoothest curves whose deviation from the drawing, in both directions and along
/// the surface, is at most `max_deviation` (mesh units, > 0). The smoothest curves are those with
/// the least total curvature.
///
/// The bound does not apply to legs, which lie between two way-points and have no stroke.
///
/// The search is for the widest slack at tau = 1 with a result within the bound. A corner of the
/// drawing that is still cut off is pinned, or the slack is narrowed around it, whichever gives the
/// smoother result. If the options have a slack, for all curves or for one, the search is for the
/// smallest tau with this slack instead. The search works on the curves in canonical order, so
/// reversing a curve, rotating a loop or listing curves in another order gives the same result. All
/// tau values of the options and `options.deviation` are ignored. If exact deviations would take
/// far longer than smoothing, their upper bounds must be within the bound. Takes up to 60 runs of
/// smooth().
///
/// The report has the tau and slack that were found, `max_deviation`, and the number of added pins.
/// If no curve within the bound was found, the best curve is returned with the termination
/// kDeviation and a warning with its deviation. When a budget is used up, the best result is
/// returned, after one more try near the drawing if none was within the bound. When cancelled, the
/// result has the drawn curves and the termination kCancelled. The smoother keeps its curve and
/// pins. Throws Error(kBadUsage) if the bound is not > 0, if no curve is set, or for another method
/// than the corridor.
SmoothingResult smooth_within(CurveSmoother& smoother, double max_deviation,
                              const SmoothingOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
