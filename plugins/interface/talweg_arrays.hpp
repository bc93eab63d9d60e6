// Reads arrays of the plugin interface with any type and stride. An array that cannot be read
// throws Failure.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "talweg_plugin.h"

namespace talweg::plugin {

/// An exception that ends a call of the interface with a status; what() is the text of last_error.
class Failure : public std::runtime_error {
 public:
  Failure(talweg_status status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  [[nodiscard]] talweg_status status() const { return status_; }

 private:
  talweg_status status_;
};

namespace detail {

[[noreturn]] inline void bad_array(const std::string& what, const std::string& problem) {
  throw Failure(TALWEG_BAD_USAGE, what + " " + problem + ".");
}

inline std::uint64_t size_of(std::uint32_t type) {
  switch (type) {
    case TALWEG_FLOAT64:
    case TALWEG_INT64:
    case TALWEG_UINT64:
      return 8;
    case TALWEG_FLOAT32:
    case TALWEG_INT32:
    case TALWEG_UINT32:
      return 4;
    case TALWEG_INT16:
    case TALWEG_UINT16:
      return 2;
    case TALWEG_INT8:
    case TALWEG_UINT8:
      return 1;
    default:
      return 0;
  }
}

/// An index: a whole number >= 0 and less than 2^32 - 1.
template <class Source>
std::uint32_t index_of(Source value, std::uint64_t row, const std::string& what) {
  if constexpr (std::is_signed_v<Source>) {
    if (value < 0) {
      bad_array(what, "has " + std::to_string(value) + " in row " + std::to_string(row) +
                          ", which is not an index");
    }
  }
  if (static_cast<std::uint64_t>(value) >= UINT32_MAX) {
    bad_array(what, "has " + std::to_string(value) + " in row " + std::to_string(row) +
                        ", which is too large for an index");
  }
  return static_cast<std::uint32_t>(value);
}

template <class Source, class Target>
void convert(const talweg_array& array, const std::string& what, Target* out) {
  const auto* bytes = static_cast<const char*>(array.data);
  const std::uint64_t dense = sizeof(Source) * std::uint64_t{array.columns};
  const std::uint64_t stride = array.stride == 0 ? dense : array.stride;
  if (std::is_same_v<Source, Target> && std::is_floating_point_v<Target> && stride == dense) {
    std::memcpy(out, bytes, static_cast<std::size_t>(array.rows * dense));
    return;
  }
  for (std::uint64_t row = 0; row < array.rows; ++row) {
    for (std::uint32_t column = 0; column < array.columns; ++column) {
      Source value;  // the array may be unaligned
      std::memcpy(&value, bytes + row * stride + column * sizeof(Source), sizeof value);
      if constexpr (std::is_floating_point_v<Target>) {
        *out++ = static_cast<Target>(value);
      } else {
        *out++ = index_of(value, row, what);
      }
    }
  }
}

}  // namespace detail

/// Throws Failure(TALWEG_BAD_USAGE) unless the array can be read: it must have this many columns, a
/// known type, not too many rows, data, and a stride that is no shorter than a row. `what` is the
/// array's name in the message.
inline void check_array(const talweg_array& array, std::uint32_t columns, const std::string& what) {
  if (array.rows == 0) return;
  const std::uint64_t bytes = detail::size_of(array.type);
  if (bytes == 0) {
    detail::bad_array(what, "has the unknown type " + std::to_string(array.type));
  }
  if (array.columns != columns) {
    detail::bad_array(
        what, "has " + std::to_string(array.columns) + " columns, not " + std::to_string(columns));
  }
  if (array.rows >= UINT32_MAX || array.rows > SIZE_MAX / (sizeof(double) * columns)) {
    detail::bad_array(what, "has " + std::to_string(array.rows) + " rows, which is too many");
  }
  if (array.data == nullptr) detail::bad_array(what, "has rows but no data");
  if (array.stride != 0 && array.stride < bytes * columns) {
    detail::bad_array(
        what, "has a stride of " + std::to_string(array.stride) + " bytes, less than a row");
  }
  if (array.stride > (std::uint64_t{1} << 32)) {
    detail::bad_array(
        what, "has a stride of " + std::to_string(array.stride) + " bytes, which is too large");
  }
}

/// The number of values in an array with this many columns. The values of a checked array fit into
/// memory.
inline std::size_t count_of(const talweg_array& array, std::uint32_t columns) {
  return static_cast<std::size_t>(array.rows) * columns;
}

namespace detail {

/// False for an array of real numbers, from which nothing is copied.
template <class Target>
bool convert_integers(const talweg_array& array, const std::string& what, Target* out) {
  switch (array.type) {
    case TALWEG_INT8:
      convert<std::int8_t>(array, what, out);
      return true;
    case TALWEG_UINT8:
      convert<std::uint8_t>(array, what, out);
      return true;
    case TALWEG_INT16:
      convert<std::int16_t>(array, what, out);
      return true;
    case TALWEG_UINT16:
      convert<std::uint16_t>(array, what, out);
      return true;
    case TALWEG_INT32:
      convert<std::int32_t>(array, what, out);
      return true;
    case TALWEG_UINT32:
      convert<std::uint32_t>(array, what, out);
      return true;
    case TALWEG_INT64:
      convert<std::int64_t>(array, what, out);
      return true;
    case TALWEG_UINT64:
      convert<std::uint64_t>(array, what, out);
      return true;
    default:
      return false;
  }
}

}  // namespace detail

/// Copies the numbers of a checked array, row by row. Throws as check_array() does.
inline void copy_numbers(const talweg_array& array, std::uint32_t columns, const std::string& what,
                         double* out) {
  check_array(array, columns, what);
  if (array.rows == 0 || detail::convert_integers(array, what, out)) return;
  if (array.type == TALWEG_FLOAT32) return detail::convert<float>(array, what, out);
  detail::convert<double>(array, what, out);
}

/// Copies the indices of a checked array, row by row. Also throws Failure(TALWEG_BAD_USAGE) for
/// real numbers, and for the first index that is negative or at least 2^32 - 1.
inline void copy_indices(const talweg_array& array, std::uint32_t columns, const std::string& what,
                         std::uint32_t* out) {
  check_array(array, columns, what);
  if (array.rows == 0 || detail::convert_integers(array, what, out)) return;
  detail::bad_array(what, "holds indices, so its numbers must be integers");
}

inline std::vector<double> numbers_of(const talweg_array& array, std::uint32_t columns,
                                      const std::string& what) {
  check_array(array, columns, what);
  std::vector<double> result(count_of(array, columns));
  copy_numbers(array, columns, what, result.data());
  return result;
}

inline std::vector<std::uint32_t> indices_of(const talweg_array& array, std::uint32_t columns,
                                             const std::string& what) {
  check_array(array, columns, what);
  std::vector<std::uint32_t> result(count_of(array, columns));
  copy_indices(array, columns, what, result.data());
  return result;
}

/// Views of dense arrays; `data` must outlive them.
inline talweg_array view(const double* data, std::uint64_t rows, std::uint32_t columns = 1) {
  return {data, rows, 0, columns, TALWEG_FLOAT64};
}
inline talweg_array view(const std::uint32_t* data, std::uint64_t rows, std::uint32_t columns = 1) {
  return {data, rows, 0, columns, TALWEG_UINT32};
}
inline constexpr talweg_array kNoArray = {nullptr, 0, 0, 1, TALWEG_FLOAT64};

/// Throws Failure(TALWEG_BAD_USAGE) for a null pointer and for a struct smaller than this
/// version's.
template <class Struct>
const Struct& checked(const Struct* pointer, const char* what) {
  if (pointer == nullptr) throw Failure(TALWEG_BAD_USAGE, std::string(what) + " is null.");
  if (pointer->size < sizeof(Struct)) {
    throw Failure(TALWEG_BAD_USAGE, std::string(what) + " has a size of " +
                                        std::to_string(pointer->size) + " bytes, less than " +
                                        std::to_string(sizeof(Struct)) + ".");
  }
  return *pointer;
}

}  // namespace talweg::plugin
