// A report entry is a named value of a report; a list of entries becomes JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace talweg {

/// A dot in a key separates a group from its member ("time_ms.trace"). In a group that is an array,
/// the part after the dot is an index ("regions.0.label", "self_contacts_at.2"); indices ascend
/// from 0 without gaps. An empty list under the key of an array makes an array that may stay empty.
struct ReportEntry {
  std::string key;
  std::variant<double, std::uint64_t, std::int64_t, bool, std::string, std::vector<double>,
               std::vector<std::int64_t>, std::vector<std::string>>
      value;
};

/// Adds entries with `prefix` (a group and a dot, or empty) before their keys.
void append(std::vector<ReportEntry>& entries, std::string_view prefix,
            std::vector<ReportEntry> more);

/// JSON of the totals, with an array `curves` of the entries of each curve if there are at least
/// two. Numbers that are not finite become null. Throws Error(kBadUsage) for a key that continues
/// the complete key of an earlier value, or skips elements of an array.
std::string to_json(const std::vector<ReportEntry>& total,
                    const std::vector<std::vector<ReportEntry>>& curves);

}  // namespace talweg
