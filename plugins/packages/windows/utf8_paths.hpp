// Included before every source for Windows: file names are UTF-8 in all strings. libstdc++ 12
// writes paths as UTF-8, but reads them in the encoding of the C locale, which msvcrt.dll cannot
// set to UTF-8.
#pragma once

#include <filesystem>
#include <string_view>

static_assert(_GLIBCXX_RELEASE == 12, "look whether libstdc++ still reads paths in the C locale");

namespace std::filesystem {

template <>
inline auto path::_S_convert<char>(const char* first, const char* last) {
  return __detail::__wstr_from_utf8(
      std::string_view(first, static_cast<std::size_t>(last - first)));
}

}  // namespace std::filesystem
