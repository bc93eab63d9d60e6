// Curve choices are parameters of several plugins on curves: which are loops, and on which side.
#pragma once

#include <cstdint>

#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// The description of the parameter "ends", whose values curve_ends() takes.
talweg_parameter ends_choice(std::uint32_t stage = TALWEG_STAGE_RUN);
/// The description of a parameter that is "both", "left" or "right". Its strings must be constants.
talweg_parameter side_choice(const char* id, const char* label, const char* doc);

}  // namespace talweg::plugins
