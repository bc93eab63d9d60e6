// A data array of VTK's XML files holds numbers, in one of several encodings.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/io/byte_cursor.hpp"

namespace talweg::formats {

/// How a file stores its arrays; the same for all of them.
struct VtkEncoding {
  bool swap = false;             ///< bytes are in the other order than this machine's
  bool wide_header = false;      ///< sizes are 64 bits
  bool compressed = false;       ///< by zlib, in blocks
  bool appended_base64 = false;  ///< otherwise the appended data is raw
  std::string_view appended;     ///< the data after the underscore
};

/// The bytes of a block that starts at the beginning of `stored`. Sizes in a header
/// are checked against the data. Throws std::runtime_error saying what is wrong.
std::string decoded_block(const VtkEncoding& encoding, std::string_view stored, bool base64);

/// Converts bytes to numbers of one type. Throws std::runtime_error when the bytes do not divide
/// evenly.
std::vector<double> numbers_of(std::string_view bytes, NumberType type, bool swap);

}  // namespace talweg::formats
