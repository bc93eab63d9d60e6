#include "talweg/core/io/label_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "talweg/core/io/field_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/label_formats.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/numpy_array.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg {
namespace formats {
namespace {

constexpr std::array<std::string_view, 6> kUsual = {"label",  "labels", "segment",
                                                    "region", "class",  "scalar_label"};

/// Doubles represent every whole number below this one.
constexpr double kMost = 9007199254740992;  // 2^53

bool is_whole(double x) { return std::abs(x) < kMost && x == std::floor(x); }

}  // namespace

std::int64_t whole_number(const WordScanner& words, std::string_view word) {
  std::int64_t whole = 0;
  if (parse(word, whole)) return whole;
  double real = 0;
  if (parse(word, real) && is_whole(real)) return static_cast<std::int64_t>(real);
  words.fail("a label (a whole number)", word);
}

LabelFile read_text_labels(const Source& source) {
  WordScanner words(source.path, source.bytes);
  LabelFile file;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    if (word.front() == '#') {
      words.next_line();
    } else {
      file.labels.push_back(whole_number(words, word));
    }
  }
  return file;
}

std::string usual_name_among(const std::vector<std::string>& names) {
  for (const std::string_view usual : kUsual) {
    if (std::find(names.begin(), names.end(), usual) != names.end()) return std::string(usual);
  }
  return "";
}

const NamedNumbers& chosen(const Source& source, const std::vector<NamedNumbers>& all,
                           const std::string& property) {
  const auto find = [&](std::string_view name) -> const NamedNumbers* {
    for (const bool of_faces : {true, false}) {
      for (const NamedNumbers& numbers : all) {
        if (numbers.of_faces == of_faces && numbers.name == name) return &numbers;
      }
    }
    return nullptr;
  };
  if (!property.empty()) {
    if (const NamedNumbers* found = find(property)) return *found;
  } else {
    for (const std::string_view name : kUsual) {
      if (const NamedNumbers* found = find(name)) return *found;
    }
  }
  std::string names;
  for (const NamedNumbers& numbers : all) {
    if (names.size() < 100) names += (names.empty() ? "" : ", ") + printable(numbers.name);
  }
  cannot_read(source.path,
              fmt::format("it has no labels called {}; {}",
                          property.empty() ? "label, labels, segment, region, class or scalar_label"
                                           : printable(property),
                          names.empty() ? "nothing in it has one number per face or vertex"
                                        : "it has " + names));
}

std::vector<std::int64_t> whole_numbers(const Source& source, const NamedNumbers& numbers,
                                        const char* element) {
  if (element == nullptr) element = numbers.of_faces ? "face" : "vertex";
  std::vector<std::int64_t> labels;
  labels.reserve(numbers.numbers.size());
  for (const double x : numbers.numbers) {
    if (!is_whole(x)) {
      cannot_read(source.path, fmt::format("{} {}: expected a whole number as {}, found {:.17g}",
                                           element, labels.size(), printable(numbers.name), x));
    }
    labels.push_back(static_cast<std::int64_t>(x));
  }
  return labels;
}

}  // namespace formats

LabelFile read_label_file(const std::filesystem::path& path, std::string_view bytes,
                          const LabelFileOptions& options) {
  const formats::Source source{path, bytes};
  const std::string extension = lower_extension(path);
  if (extension == ".annot") return formats::read_annot_labels(source);
  if (extension == ".gii") return formats::read_gifti_labels(source, options.property);
  if (extension == ".csv") return formats::read_csv_labels(source, options.property);
  if (extension == ".dpv") {
    return {formats::whole_numbers(source, {"label", false, formats::read_dpv(source)})};
  }
  if (extension == ".npy") {
    return {formats::whole_numbers(source, {"label", false, formats::read_npy(source)}, "number")};
  }
  if (extension == ".label") return formats::read_freesurfer_label(source, options.vertex_count);
  if (extension == ".ply") return formats::read_ply_labels(source, options.property);
  if (extension == ".vtk") return formats::read_vtk_labels(source, options.property);
  if (extension == ".vtp") return formats::read_vtp_labels(source, options.property);
  return formats::read_text_labels(source);
}

LabelFile read_label_file(const std::filesystem::path& path, const LabelFileOptions& options) {
  const std::string bytes = read_file(path);
  return read_label_file(path, bytes, options);
}

}  // namespace talweg
