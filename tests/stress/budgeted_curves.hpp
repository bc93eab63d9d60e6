// Budgeted curves are what is smoothed with a random budget of counted work.
#pragma once

#include <string>

#include "stress/random.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::stress {

/// Smooths the curves that are set with a budget, within `bound` (mesh units) unless that is 0:
/// twice the same; without it nothing has changed; where no budget was used up, the result is as
/// without; the deviations that are told are not smaller than the true ones. Says what does not
/// hold; empty where everything does.
std::string breaks_its_budget(CurveSmoother& smoother, SmoothingOptions options, double bound,
                              Random& random);

}  // namespace talweg::stress
