// The plot of a comparison shows the trade-off between smooth and close.
#pragma once

#include <string>

#include "compare/comparison.hpp"

namespace talweg::driver {

/// An SVG of total curvature (rad, logarithmic) against the larger deviation (mean edges near the
/// drawing, logarithmic), with a line per method through the runs that keep the curve's topology;
/// other runs are hollow. Farther left and down is better.
std::string comparison_plot(const Comparison& comparison, const std::string& title);

}  // namespace talweg::driver
