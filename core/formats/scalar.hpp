// Numbers of binary files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace talweg::formats {

enum class Scalar {
  kInt8,
  kUInt8,
  kInt16,
  kUInt16,
  kInt32,
  kUInt32,
  kInt64,
  kUInt64,
  kFloat32,
  kFloat64
};

constexpr std::size_t size_of(Scalar type) {
  constexpr std::array<std::size_t, 10> kSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

template <class T>
T load(const char* bytes, bool big_endian) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) {
    std::reverse(raw.begin(), raw.end());
  }
  return std::bit_cast<T>(raw);
}

/// Integers beyond 2^53 are rounded; no valid index is that large.
inline double load_number(Scalar type, const char* bytes, bool big_endian) {
  switch (type) {
    case Scalar::kInt8:
      return load<std::int8_t>(bytes, big_endian);
    case Scalar::kUInt8:
      return load<std::uint8_t>(bytes, big_endian);
    case Scalar::kInt16:
      return load<std::int16_t>(bytes, big_endian);
    case Scalar::kUInt16:
      return load<std::uint16_t>(bytes, big_endian);
    case Scalar::kInt32:
      return load<std::int32_t>(bytes, big_endian);
    case Scalar::kUInt32:
      return load<std::uint32_t>(bytes, big_endian);
    case Scalar::kInt64:
      return static_cast<double>(load<std::int64_t>(bytes, big_endian));
    case Scalar::kUInt64:
      return static_cast<double>(load<std::uint64_t>(bytes, big_endian));
    case Scalar::kFloat32:
      return static_cast<double>(load<float>(bytes, big_endian));
    case Scalar::kFloat64:
      return load<double>(bytes, big_endian);
  }
  return 0;
}

/// The value as an index below `count`; nothing where it is none.
inline std::optional<std::uint32_t> index_below(double value, std::size_t count) {
  constexpr double kLimit = 4294967295.0;  // the largest 32-bit number marks an invalid index
  if (!(value >= 0 && value < kLimit && value < static_cast<double>(count))) return std::nullopt;
  if (value != std::floor(value)) return std::nullopt;
  return static_cast<std::uint32_t>(value);
}

}  // namespace talweg::formats
