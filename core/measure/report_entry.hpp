// A report entry is one named value of a report, and a list of them becomes JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace talweg {

/// A dot in a key says that the value belongs to a group ("time_ms.trace"). In a group that is an
/// array, the part after the dot is an index ("regions.0.label", "self_contacts_at.2"): they ascend
/// from 0 without gaps. An empty list under the array's own key is an array that may stay empty.
struct ReportEntry {
  std::string key;
  std::variant<double, std::uint64_t, std::int64_t, bool, std::string, std::vector<double>,
               std::vector<std::int64_t>, std::vector<std::string>>
      value;
};

/// Adds entries under the group `prefix`, which ends with a dot.
void append(std::vector<ReportEntry>& entries, std::string_view prefix,
            std::vector<ReportEntry> more);

/// JSON of the totals, with an array `curves` of the entries of each curve, which is left out for
/// fewer than two. Numbers that are not finite become null. Throws Error(kBadUsage) naming a key
/// that goes on where an earlier one ended, or leaves out elements of an array.
std::string to_json(const std::vector<ReportEntry>& total,
                    const std::vector<std::vector<ReportEntry>>& curves);

}  // namespace talweg
