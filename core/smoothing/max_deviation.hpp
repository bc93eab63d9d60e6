// A bound on the deviation is the parameter that users understand: no farther than this.
#pragma once

#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {

/// The smoothest curves found whose deviation from the drawing, in both directions and along the
/// surface, is at most `max_deviation` (mesh units, > 0): of those within the bound the one with
/// the least total curvature.
///
/// Looks for the smallest tau that keeps the result within the bound of the drawing, for two
/// slacks, and for the widest slack that does. A corner of the drawing that is cut off all the same
/// is pinned, or held by a larger tau, or the slack is narrowed around it, whichever is smoother.
/// All of this in the curves' canonical order, so a drawing that is reversed, begun elsewhere or
/// listed otherwise has the same result. `options.tau` and `options.deviation` are not looked at,
/// `options.slack` is the only slack where it is given. 20 to 110 runs of smooth().
///
/// The report has the tau and slack that were found, `max_deviation`, and how many points were
/// pinned. Where no curve within the bound was found the best one is returned, its `termination` is
/// "deviation", and a warning says how far off it is. When cancelled the curves are those drawn,
/// and `termination` says so. The smoother keeps its curve and its pins.
/// Throws Error(kBadUsage) when the bound is not > 0, no curve is set, or the curve was set with
/// another method than the corridor.
SmoothingResult smooth_within(CurveSmoother& smoother, double max_deviation,
                              const SmoothingOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
