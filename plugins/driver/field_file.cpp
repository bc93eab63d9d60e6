#include "field_file.hpp"

#include <iterator>

#include <fmt/format.h>

#include "output_file.hpp"
#include "talweg/core/io/field_values.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

std::vector<double> read_field(const std::string& path) { return read_field_values(path); }

std::vector<double> read_field(const std::string& path, std::size_t vertices) {
  std::vector<double> values = read_field(path);
  if (values.size() != vertices) {
    throw Error(ErrorCode::kBadFile, path + ": " + std::to_string(values.size()) +
                                         " values, but the mesh has " + std::to_string(vertices) +
                                         " vertices.");
  }
  return values;
}

void write_field(const std::string& path, const std::vector<double>& values) {
  std::string text;
  for (const double value : values) fmt::format_to(std::back_inserter(text), "{:.17g}\n", value);
  write_output(path, text);
}

}  // namespace talweg::driver
