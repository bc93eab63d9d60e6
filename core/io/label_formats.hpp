// Each label format has its own function behind label_file.hpp: bytes to labels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/label_file.hpp"

namespace talweg::formats {

/// A property or array of numbers, one per face (cell) or vertex (point).
struct NamedNumbers {
  std::string name;
  bool of_faces = false;
  std::vector<double> numbers;
};

/// Picks the property or array to read; those of faces come first. Throws Error(kBadFile) with a
/// list of those in the file if none fits.
const NamedNumbers& chosen(const Source& source, const std::vector<NamedNumbers>& all,
                           const std::string& property);
/// Throws Error(kBadFile) naming the first number that is not whole.
std::vector<std::int64_t> whole_numbers(const Source& source, const NamedNumbers& numbers);

LabelFile read_annot_labels(const Source& source);
LabelFile read_freesurfer_label(const Source& source, std::size_t vertex_count);
LabelFile read_ply_labels(const Source& source, const std::string& property);
LabelFile read_vtk_labels(const Source& source, const std::string& property);
LabelFile read_vtp_labels(const Source& source, const std::string& property);

}  // namespace talweg::formats
