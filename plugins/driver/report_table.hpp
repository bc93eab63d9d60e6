// The report table is the report of a smoothing as text for people.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/measure/report.hpp"

namespace talweg::driver {

/// The table begins with the decisive warnings and the deviation of the result from the drawing.
/// Lines with values before and after smoothing follow, then deviations, work and times, and all
/// other warnings.
std::string table_of(const SmoothingReport& report);

}  // namespace talweg::driver
