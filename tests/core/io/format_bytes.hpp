// Bytes of formats for files of tests.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {

/// Appends a number, big-endian if `big`, otherwise little-endian.
template <class T>
void put_number(std::string& bytes, T value, bool big = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// The error message of reading, without "Cannot read NAME"; empty if reading succeeds.
inline std::string refusal_of(const std::string& name, std::string_view bytes) {
  try {
    read_mesh(name, bytes);
  } catch (const Error& error) {
    const std::string what = error.what(), start = "Cannot read " + name;
    if (error.code() != ErrorCode::kBadFile) return "no kBadFile: " + what;
    return what.starts_with(start) ? what.substr(start.size()) : "no name: " + what;
  }
  return "";
}

}  // namespace talweg::test
