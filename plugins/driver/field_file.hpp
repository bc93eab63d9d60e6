// A field file holds one number per vertex.
#pragma once

#include <string>
#include <vector>

namespace talweg::driver {

/// Reads a field as read_field_values() does. Throws Error(kBadFile).
std::vector<double> read_field(const std::string& path);
/// The same; throws if the number of values is not `vertices`.
std::vector<double> read_field(const std::string& path, std::size_t vertices);
/// Writes one number per line with 17 digits; "inf" for infinite ones.
void write_field(const std::string& path, const std::vector<double>& values);

}  // namespace talweg::driver
