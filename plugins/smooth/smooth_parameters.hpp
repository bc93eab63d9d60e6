// The parameters of talweg.smooth, and what they mean to the library.
#pragma once

#include <vector>

#include "talweg/core/curve_smoother.hpp"
#include "talweg/plugin/talweg_parameters.hpp"

namespace talweg::plugins {

std::vector<talweg_parameter> smooth_parameters();

/// Pins are not in it. Throws plugin::Failure(TALWEG_BAD_USAGE) for parameters that do not go
/// together.
CurveOptions curve_options_of(const plugin::Parameters& parameters);
/// Neither progress nor the slack field is in it.
SmoothingOptions smoothing_options_of(const plugin::Parameters& parameters);

}  // namespace talweg::plugins
