// Packed bytes are base64, zlib or both.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talweg::formats {

/// The bytes that a base64 text stands for; blanks and ends of lines in it are skipped. Throws
/// std::runtime_error saying what is wrong.
std::string from_base64(std::string_view text);

/// Unpacks `size` bytes from zlib or gzip data. Throws std::runtime_error if the data unpacks to
/// another number of bytes, or is damaged. Sets aside no more than the data can unpack to.
std::string unpacked(std::string_view packed, std::size_t size);

}  // namespace talweg::formats
