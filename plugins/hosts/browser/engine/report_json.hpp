// Reports in the form of the driver's JSON.
#pragma once

#include "answer.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::browser {

/// The totals; for several curves also `curves`, a report for each. Numbers that are not finite are
/// null.
Json report_json(const host::Results& results);

/// An entry's number, or null if there is none or it is not finite.
Json number_or_null(const host::Results& results, const char* key, std::int64_t curve);

}  // namespace talweg::browser
