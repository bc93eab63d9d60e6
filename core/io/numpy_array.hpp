// A NumPy array file (.npy) holds the numbers of one array.
#pragma once

#include <vector>

#include "talweg/core/io/curve_formats.hpp"

namespace talweg::formats {

/// The numbers of an array of one dimension, or of two dimensions of which one is 1: whole numbers
/// of 8 to 64 bits, truth values, and real numbers of 32 and 64 bits, in both byte orders; versions
/// 1 to 3. Format: "NEP 1, A simple file format for NumPy arrays" and numpy.lib.format. Whole
/// numbers from 2^53 on are rounded. Throws Error(kBadFile).
std::vector<double> read_npy(const Source& source);

}  // namespace talweg::formats
