// The table of a comparison is for people, as JSON, or as comma-separated values.
#pragma once

#include <string>

#include "compare/comparison.hpp"

namespace talweg::driver {

/// Aligned Markdown with one row per run.
std::string comparison_table(const Comparison& comparison);
/// Remarks below the table: refusals and, for a sweep, where the first method is beaten.
std::string comparison_remarks(const Comparison& comparison);
std::string comparison_json(const Comparison& comparison);
std::string comparison_csv(const Comparison& comparison);

}  // namespace talweg::driver
