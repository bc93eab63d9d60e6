// Curve choices are parameters that several plugins share: ends of curves, and the side of a curve.
#pragma once

#include <cstdint>

#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// The description of the parameter "ends", whose values curve_ends() takes.
talweg_parameter ends_choice(std::uint32_t stage = TALWEG_STAGE_RUN);
/// The description of a parameter with the choices "both", "left" and "right". Its strings must be
/// constants.
talweg_parameter side_choice(const char* id, const char* label, const char* doc);

}  // namespace talweg::plugins
