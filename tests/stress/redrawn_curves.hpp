// Redrawn curves are the same curves drawn in another way.
#pragma once

#include <string>

#include "stress/random.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::stress {

/// Smooths the set curves as they are and redrawn: some reversed, loops begun elsewhere, the set in
/// another order; within `bound` (mesh units) unless it is 0. Returns a sentence on the first
/// difference, even of one bit, or "".
std::string differs_when_redrawn(CurveSmoother& smoother, const CurveOptions& curve_options,
                                 const SmoothingOptions& options, double bound, Random& random);

}  // namespace talweg::stress
