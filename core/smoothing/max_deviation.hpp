// A bound on the deviation is the parameter that users understand: no farther than this.
#pragma once

#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {

/// The smoothest curves found whose deviation from the drawing, in both directions and along the
/// surface, is at most `max_deviation` (mesh units, > 0). The smoothest are those with the least
/// total curvature.
///
/// Between two way-points there is no stroke to be near to, so legs do not count.
///
/// Searches for the smallest tau that keeps the result within the bound, for two slacks, and for
/// the widest slack that does. Where a corner of the drawing is still cut off, it is pinned, or
/// held by a larger tau, or the slack is narrowed around it, whichever gives the smoother result.
/// The search works on the curves in their canonical order, so a drawing that is reversed, begun
/// elsewhere or listed in another order has the same result. `options.tau` and `options.deviation`
/// are ignored; if `options.slack` is given, it is the only slack that is tried. Takes 20 to 110
/// runs of smooth().
///
/// The report has the tau and slack that were found, `max_deviation`, and how many points were
/// pinned. If no curve within the bound was found, the best one is returned, its `termination` is
/// "deviation", and a warning says how far off it is. When cancelled, the curves are those drawn,
/// and `termination` says so. The smoother keeps its curve and its pins.
/// Throws Error(kBadUsage) when the bound is not > 0, no curve is set, or the curve was set with
/// another method than the corridor.
SmoothingResult smooth_within(CurveSmoother& smoother, double max_deviation,
                              const SmoothingOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
