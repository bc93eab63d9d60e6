// The verdict of a comparison says which methods are smoother than the first at no larger
// deviation.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compare/comparison.hpp"

namespace talweg::driver {

/// Where the first method is beaten: the runs of others (by index) that keep the curve's topology
/// and are smoother than every run of the first method that deviates no more. Differences up to 2 %
/// in deviation, and up to 2 % or 0.02 rad in curvature, are a tie. Methods that differ from the
/// first only in the swept parameter count as the first.
std::vector<std::size_t> beaten_by(const Comparison& comparison);
/// The number of runs that were judged.
std::size_t judged_runs(const Comparison& comparison);
/// The deviations at which others beat the first method in the steps of its sweep, ascending; none
/// if bounded_method() is not the first method.
std::vector<std::optional<double>> bounds_to_try(const Comparison& comparison);

}  // namespace talweg::driver
