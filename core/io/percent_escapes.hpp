// Percent escapes such as %20 stand for bytes in URIs and in the names of VTK's files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talweg::formats {

/// The value of a hexadecimal digit; -1 for other characters.
inline int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// The text with bytes in place of their escapes; a % that begins no escape stays.
inline std::string without_escapes(std::string_view text) {
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool two_more = text[k] == '%' && k + 2 < text.size();
    const int high = two_more ? hex_digit(text[k + 1]) : -1;
    const int low = two_more ? hex_digit(text[k + 2]) : -1;
    if (high < 0 || low < 0) {
      result += text[k];
      continue;
    }
    result += static_cast<char>(16 * high + low);
    k += 2;
  }
  return result;
}

}  // namespace talweg::formats
