// The deviation choice is the parameter for how a report measures deviation.
#pragma once

#include "talweg/core/measure/deviation_measure.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// The description of the parameter "deviation".
talweg_parameter deviation_choice();
/// The same with kAutomatic as an additional choice, and as the default.
talweg_parameter deviation_choice_by_tau();
/// The value of either parameter.
DeviationMeasure deviation_of(const plugin::Parameters& parameters);

}  // namespace talweg::plugins
