// Quantiles and shares of measured values.
#pragma once

#include <span>
#include <vector>

namespace talweg::quality {

/// The quantile with linear interpolation: 0 the least, 0.5 the median, 1 the largest value. 0
/// without values.
double quantile(std::vector<double> values, double q);

/// The part of the values that are at most `bound`; 1 without values.
double share_within(std::span<const double> values, double bound);

}  // namespace talweg::quality
