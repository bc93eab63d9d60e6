// Array views pass vectors of the library to a host without a copy.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "talweg/plugin/talweg_arrays.hpp"

namespace talweg::plugins {

template <class Number, std::size_t n>
talweg_array view_of(const std::vector<std::array<Number, n>>& rows) {
  return plugin::view(rows.empty() ? nullptr : rows.front().data(), rows.size(), n);
}
inline talweg_array view_of(const std::vector<std::uint32_t>& values) {
  return plugin::view(values.data(), values.size());
}

}  // namespace talweg::plugins
