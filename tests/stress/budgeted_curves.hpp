// Budgeted curves are smoothed with a random budget of counted work.
#pragma once

#include <string>

#include "stress/random.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::stress {

/// Smooths the set curves with a budget, within `bound` (mesh units) unless it is 0, and checks:
/// the result is the same twice; a later run without a budget is unaffected; a budget that is not
/// used up changes nothing; reported deviations are not smaller than the true ones. Returns a
/// sentence on the first check that fails, or "".
std::string breaks_its_budget(CurveSmoother& smoother, SmoothingOptions options, double bound,
                              Random& random);

}  // namespace talweg::stress
