// Redrawn curves are the same curves as somebody else would draw them.
#pragma once

#include <string>

#include "stress/random.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::stress {

/// Smooths the curves that are set as they are and redrawn: some reversed, closed ones begun
/// elsewhere, the set listed in another order; within `bound` (mesh units) unless that is 0. Says
/// what differs by as much as a bit; empty where nothing does.
std::string differs_when_redrawn(CurveSmoother& smoother, const CurveOptions& curve_options,
                                 const SmoothingOptions& options, double bound, Random& random);

}  // namespace talweg::stress
