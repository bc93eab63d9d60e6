#include "talweg/core/io/field_values.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "talweg/core/io/field_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/numpy_array.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg {
namespace formats {

std::vector<double> read_dpv(const Source& source) {
  WordScanner words(source.path, source.bytes);
  std::vector<double> values;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    if (words.integer(word, "a vertex's number") != static_cast<std::int64_t>(values.size())) {
      words.fail(fmt::format("the number {}", values.size()), word);
    }
    for (int k = 0; k < 3; ++k) words.number(words.word_on_line(), "a coordinate");
    values.push_back(words.number(words.word_on_line(), "a value"));
    if (const std::string_view more = words.word_on_line(); !more.empty()) {
      words.fail("the end of the line after number, x, y, z and value", more);
    }
  }
  return values;
}

std::vector<double> read_text_values(const Source& source) {
  WordScanner words(source.path, source.bytes);
  std::vector<double> values;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    double value = 0;
    if (!parse(word, value)) words.fail("a number", word);
    values.push_back(value);
  }
  return values;
}

}  // namespace formats

namespace {

constexpr std::string_view kOfFreeSurfer[] = {".curv", ".thickness", ".sulc", ".area", ".volume"};

}  // namespace

std::vector<double> read_field_values(const std::filesystem::path& path) {
  return read_field_values(path, read_file(path));
}

std::vector<double> read_field_values(const std::filesystem::path& path, std::string_view bytes) {
  const formats::Source source{path, bytes, {}};
  const std::string extension = lower_extension(path);
  if (extension == ".gii") return formats::read_gifti_values(source);
  if (extension == ".npy") return formats::read_npy(source);
  if (extension == ".dpv") return formats::read_dpv(source);
  const bool named = std::find(std::begin(kOfFreeSurfer), std::end(kOfFreeSurfer), extension) !=
                     std::end(kOfFreeSurfer);
  if (named || bytes.starts_with("\xFF\xFF\xFF")) return formats::read_curv(source);
  return formats::read_text_values(source);
}

}  // namespace talweg
