// A byte cursor reads numbers from a binary file, one after the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "talweg/core/mesh/number_type.hpp"

namespace talweg {

/// One value at `at`, which need not be aligned; the bytes are reversed first if `swap` is set.
template <class T>
T load(const char* at, bool swap) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (swap) std::reverse(bytes.begin(), bytes.end());
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

/// A number of any type, converted to double. Integers beyond 2^53 are rounded; no index is that
/// large.
inline double load_number(NumberType type, const char* at, bool swap) {
  switch (type) {
    case NumberType::kInt8:
      return load<std::int8_t>(at, swap);
    case NumberType::kUint8:
      return load<std::uint8_t>(at, swap);
    case NumberType::kInt16:
      return load<std::int16_t>(at, swap);
    case NumberType::kUint16:
      return load<std::uint16_t>(at, swap);
    case NumberType::kInt32:
      return load<std::int32_t>(at, swap);
    case NumberType::kUint32:
      return load<std::uint32_t>(at, swap);
    case NumberType::kInt64:
      return static_cast<double>(load<std::int64_t>(at, swap));
    case NumberType::kUint64:
      return static_cast<double>(load<std::uint64_t>(at, swap));
    case NumberType::kFloat32:
      return static_cast<double>(load<float>(at, swap));
    case NumberType::kFloat64:
      return load<double>(at, swap);
  }
  return 0;
}

/// A whole number of at most 32 bits; 0 for other types, which callers must reject before.
inline std::int64_t load_integer(NumberType type, const char* at, bool swap) {
  switch (type) {
    case NumberType::kInt8:
      return load<std::int8_t>(at, swap);
    case NumberType::kUint8:
      return load<std::uint8_t>(at, swap);
    case NumberType::kInt16:
      return load<std::int16_t>(at, swap);
    case NumberType::kUint16:
      return load<std::uint16_t>(at, swap);
    case NumberType::kInt32:
      return load<std::int32_t>(at, swap);
    case NumberType::kUint32:
      return load<std::uint32_t>(at, swap);
    default:
      return 0;
  }
}

/// The unread part of a file.
class ByteCursor {
 public:
  explicit ByteCursor(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }
  [[nodiscard]] std::string_view rest() const { return bytes_; }
  /// The next n bytes; nullptr, and nothing is taken, if fewer are left.
  const char* take(std::size_t n) {
    if (n > bytes_.size()) return nullptr;
    const char* at = bytes_.data();
    bytes_.remove_prefix(n);
    return at;
  }

 private:
  std::string_view bytes_;
};

}  // namespace talweg
