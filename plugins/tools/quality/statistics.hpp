// Statistics are ranks and shares of what was measured.
#pragma once

#include <span>
#include <vector>

namespace talweg::quality {

/// Linear between the ranks: 0 the least, 0.5 the median, 1 the largest. 0 of nothing.
double quantile(std::vector<double> values, double q);

/// The part of the values that are at most `bound`; 1 of nothing.
double share_within(std::span<const double> values, double bound);

}  // namespace talweg::quality
