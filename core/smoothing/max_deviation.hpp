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
/// Searches for the widest slack that keeps the result within the bound at tau = 1. Where a corner
/// of the drawing is still cut off, it is pinned, or the slack is narrowed around it, whichever
/// gives the smoother result. If the options have a slack, for all curves or for one, it searches
/// for the smallest tau with that slack instead. The search works on the curves in their canonical
/// order, so a drawing that is reversed, begun elsewhere or listed in another order has the same
/// result. Every tau of the options and `options.deviation` are ignored; where exact deviations
/// would take far longer than smoothing, upper bounds of them must be within the bound. Takes up to
/// 60 runs of smooth(); each point that is pinned is compared with all pins.
///
/// The report has the tau and slack that were found, `max_deviation`, and how many points were
/// pinned. If no curve within the bound was found, the best one is returned, its `termination` is
/// "deviation", and a warning says how far off it is. When a budget is used up, the best result so
/// far is returned, after one more try near the drawing if none was within the bound. When
/// cancelled, the curves are those drawn, and `termination` says so. The smoother keeps its curve
/// and its pins. Throws Error(kBadUsage) when the bound is not > 0, no curve is set, or the curve
/// was set with another method than the corridor.
SmoothingResult smooth_within(CurveSmoother& smoother, double max_deviation,
                              const SmoothingOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
