// A field file holds one number per vertex.
#pragma once

#include <string>
#include <vector>

namespace talweg::driver {

/// Numbers separated by blanks or ends of lines. Throws Error(kBadFile).
std::vector<double> read_field(const std::string& path);
/// The same, and there must be as many as the mesh has vertices.
std::vector<double> read_field(const std::string& path, std::size_t vertices);
/// One number a line, 17 digits; "inf" for infinite ones.
void write_field(const std::string& path, const std::vector<double>& values);

}  // namespace talweg::driver
