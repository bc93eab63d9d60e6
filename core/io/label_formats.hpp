// Each label format has its own reader behind label_file.hpp: bytes to labels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/label_file.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {

/// A property or array of numbers, one per face (cell) or vertex (point).
struct NamedNumbers {
  std::string name;
  bool of_faces = false;
  std::vector<double> numbers;
};

/// Picks the property or array to read; properties of faces come first. Throws Error(kBadFile) with
/// a list of the properties in the file if none fits.
const NamedNumbers& chosen(const Source& source, const std::vector<NamedNumbers>& all,
                           const std::string& property);
/// The first of the usual names of labels (label, labels, ...) that is among `names`; empty if none
/// is.
std::string usual_name_among(const std::vector<std::string>& names);
/// Converts to whole numbers. Throws Error(kBadFile) naming the first number that is not whole and
/// its face or vertex; `element` is the word for the face or vertex.
std::vector<std::int64_t> whole_numbers(const Source& source, const NamedNumbers& numbers,
                                        const char* element = nullptr);

/// One whole number of a text, which may be written as 1.0e+00. Throws Error(kBadFile) naming the
/// line.
std::int64_t whole_number(const WordScanner& words, std::string_view word);

/// The longest name of a label that is kept.
inline constexpr std::size_t kLongestName = 255;

LabelFile read_text_labels(const Source& source);
LabelFile read_csv_labels(const Source& source, const std::string& property);
LabelFile read_gifti_labels(const Source& source, const std::string& map);
LabelFile read_annot_labels(const Source& source);
LabelFile read_freesurfer_label(const Source& source, std::size_t vertex_count);
LabelFile read_ply_labels(const Source& source, const std::string& property);
LabelFile read_vtk_labels(const Source& source, const std::string& property);
LabelFile read_vtp_labels(const Source& source, const std::string& property);

}  // namespace talweg::formats
