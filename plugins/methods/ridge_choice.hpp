// The ridge choice is the parameters that move drawings onto ridges and valleys.
#pragma once

#include <vector>

#include "talweg/core/ridges/ridge_snapping.hpp"
#include "talweg/plugin/talweg_parameters.hpp"

namespace talweg::plugins {

/// The parameters `ridges`, `ridge_kind` and `ridge_band` of this stage.
std::vector<talweg_parameter> ridge_choice(std::uint32_t stage);
RidgeOptions ridge_options_of(const plugin::Parameters& parameters);

}  // namespace talweg::plugins
