// The report table is the report for people.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/measure/report.hpp"

namespace talweg::driver {

/// What is decisive and how far apart result and drawing lie, then lines with before and after side
/// by side, deviations, work and times, and all other warnings.
std::string table_of(const SmoothingReport& report);

}  // namespace talweg::driver
