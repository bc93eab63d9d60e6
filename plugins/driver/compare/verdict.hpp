// The verdict of a comparison says who is smoother at no more deviation.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compare/comparison.hpp"

namespace talweg::driver {

/// Where the first method is beaten: the runs of others (by index) that keep the curve's kind and
/// are smoother than every run of the first that deviates no more. 2 % in deviation, and 2 % or
/// 0.02 rad in curvature, are a tie. Methods that differ from the first in the swept parameter only
/// count as the first.
std::vector<std::size_t> beaten_by(const Comparison& comparison);
/// How many runs were judged for that.
std::size_t judged_runs(const Comparison& comparison);
/// The deviations at which others beat the first method in the steps of its sweep, ascending; none
/// where bounded_method() is another method than the first.
std::vector<std::optional<double>> bounds_to_try(const Comparison& comparison);

}  // namespace talweg::driver
