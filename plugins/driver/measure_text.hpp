// The measure text is the table that `talweg measure` prints.
#pragma once

#include <string>

#include "talweg/core/measure/curve_measurement.hpp"

namespace talweg::driver {

/// A block for each of the two files, the deviation between them, and the warnings.
std::string measure_table(const CurveMeasurement& m, const std::string& name,
                          const std::string& other);

}  // namespace talweg::driver
