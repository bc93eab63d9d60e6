#include "field_file.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "output_file.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

std::vector<double> read_field(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw Error(ErrorCode::kBadFile, path + ": cannot be opened.");
  std::vector<double> values;
  for (std::string word; in >> word;) {
    char* end = nullptr;
    values.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != '\0') {
      throw Error(ErrorCode::kBadFile, path + ": value " + std::to_string(values.size()) + " (\"" +
                                           word.substr(0, 40) + "\") is not a number.");
    }
  }
  return values;
}

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
