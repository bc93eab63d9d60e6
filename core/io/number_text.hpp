// Numbers in text are read the same way with every standard library.
#pragma once

#include <charconv>
#include <cstdint>

#ifdef TALWEG_FAST_FLOAT
#include <cmath>
#include <system_error>

#include <fast_float/fast_float.h>
#endif

namespace talweg {

/// std::from_chars; for real numbers fast_float's if the standard library has none.
inline std::from_chars_result from_text(const char* first, const char* last, double& value) {
#ifdef TALWEG_FAST_FLOAT
  const auto [end, error] = fast_float::from_chars(first, last, value);
  // fast_float returns an infinity for a number that is too large. A written infinity ends in a
  // letter.
  const bool written = end != first && (end[-1] | 0x20) >= 'a';
  const bool too_large = error == std::errc{} && std::isinf(value) && !written;
  return {end, too_large ? std::errc::result_out_of_range : error};
#else
  return std::from_chars(first, last, value);
#endif
}

inline std::from_chars_result from_text(const char* first, const char* last, std::int64_t& value) {
  return std::from_chars(first, last, value);
}

}  // namespace talweg
