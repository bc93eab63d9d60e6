// Words of a text are parsed alike for every format, and independently of the locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace talweg {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Parses a whole word, which may begin with a plus sign; false if the word is not a number. A
/// number may be infinite or NaN; a number too small for a double becomes 0, a number too large
/// infinite.
bool parse(std::string_view word, double& value);
bool parse(std::string_view word, std::int64_t& value);

/// At most `longest` bytes of a text, made printable, for a message; ends in "..." if it was cut.
std::string printable(std::string_view text, std::size_t longest = 40);

}  // namespace talweg
