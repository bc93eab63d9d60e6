// Each format of numbers per vertex has its own reader behind field_values.hpp.
#pragma once

#include <vector>

#include "talweg/core/io/curve_formats.hpp"

namespace talweg::formats {

/// FreeSurfer's data per vertex: lines `number x y z value`, numbers counted from 0.
std::vector<double> read_dpv(const Source& source);
/// FreeSurfer's binary values per vertex, as of `.curv`, `.thickness`, `.sulc` and `.area`: the new
/// format (magic number FFFFFF, 32-bit floats) and the old one (16-bit hundredths), big-endian.
std::vector<double> read_curv(const Source& source);
/// The first array of a GIFTI file with one number per vertex, see gifti.hpp.
std::vector<double> read_gifti_values(const Source& source);
/// Numbers separated by blanks or ends of lines; `nan` and `inf` are numbers.
std::vector<double> read_text_values(const Source& source);

}  // namespace talweg::formats
