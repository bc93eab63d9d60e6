// The report table is the report for people.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/measure/report.hpp"

namespace talweg::driver {

/// Lines with before and after side by side, then deviations, work and times.
std::string table_of(const SmoothingReport& report);

}  // namespace talweg::driver
