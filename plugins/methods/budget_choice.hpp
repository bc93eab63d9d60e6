// The budget choice is the two parameters that limit the time and work of a run.
#pragma once

#include <vector>

#include "talweg/intrinsic/budget.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// The descriptions of the parameters "budget" and "budget_work".
std::vector<talweg_parameter> budget_parameters();
/// The values of these parameters.
Budget budget_of(const plugin::Parameters& parameters);

}  // namespace talweg::plugins
