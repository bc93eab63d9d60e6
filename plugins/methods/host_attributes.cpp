#include "host_attributes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "talweg/plugin/talweg_arrays.hpp"

namespace talweg::plugins {
namespace {

[[noreturn]] void bad(const std::string& name, const std::string& what) {
  throw plugin::Failure(TALWEG_BAD_USAGE, fmt::format("The attribute \"{}\" {}.", name, what));
}

Carry carry_of(std::uint32_t rule) {
  switch (rule) {
    case TALWEG_CARRY_LINEAR:
      return Carry::kLinear;
    case TALWEG_CARRY_ROUNDED:
      return Carry::kRounded;
    case TALWEG_CARRY_NEAREST:
      return Carry::kNearest;
    default:
      return Carry::kDirection;
  }
}

template <class Number>
void write(const std::vector<double>& values, std::vector<char>& bytes) {
  bytes.resize(values.size() * sizeof(Number));
  for (std::size_t k = 0; k < values.size(); ++k) {
    double value = values[k];
    if constexpr (std::is_integral_v<Number>) {
      value = std::clamp(std::round(value), static_cast<double>(std::numeric_limits<Number>::min()),
                         static_cast<double>(std::numeric_limits<Number>::max()));
    }
    const auto number = static_cast<Number>(value);
    std::memcpy(&bytes[k * sizeof(Number)], &number, sizeof number);
  }
}

/// The values as numbers of that type.
std::vector<char> bytes_of(const std::vector<double>& values, std::uint32_t type) {
  std::vector<char> bytes;
  switch (type) {
    case TALWEG_FLOAT32:
      write<float>(values, bytes);
      break;
    case TALWEG_INT8:
      write<std::int8_t>(values, bytes);
      break;
    case TALWEG_UINT8:
      write<std::uint8_t>(values, bytes);
      break;
    case TALWEG_INT16:
      write<std::int16_t>(values, bytes);
      break;
    case TALWEG_UINT16:
      write<std::uint16_t>(values, bytes);
      break;
    case TALWEG_INT32:
      write<std::int32_t>(values, bytes);
      break;
    case TALWEG_UINT32:
      write<std::uint32_t>(values, bytes);
      break;
    case TALWEG_INT64:
      write<std::int64_t>(values, bytes);
      break;
    case TALWEG_UINT64:
      write<std::uint64_t>(values, bytes);
      break;
    default:
      write<double>(values, bytes);
  }
  return bytes;
}

talweg_array view_of(const std::vector<char>& bytes, std::size_t rows, std::uint32_t columns,
                     std::uint32_t type) {
  return {bytes.data(), rows, 0, columns, type};
}

/// Entries of corners; TALWEG_NO_ENTRY is allowed, which is no index elsewhere.
std::vector<std::array<std::uint32_t, 3>> corners_of(const talweg_attribute& given,
                                                     std::size_t faces, std::size_t entries) {
  const std::string name = given.name;
  plugin::check_array(given.corners, 3, "The corners of the attribute \"" + name + "\"");
  if (given.corners.rows != faces) {
    bad(name, fmt::format("has corners for {} triangles, and the mesh has {}", given.corners.rows,
                          faces));
  }
  if (given.corners.type != TALWEG_UINT32) bad(name, "has corners that are no 32-bit indices");
  std::vector<std::array<std::uint32_t, 3>> corners(faces);
  const auto* bytes = static_cast<const char*>(given.corners.data);
  const std::uint64_t stride = given.corners.stride == 0 ? 12 : given.corners.stride;
  for (std::size_t f = 0; f < faces; ++f) {
    std::memcpy(corners[f].data(), bytes + f * stride, sizeof corners[f]);
    for (const std::uint32_t entry : corners[f]) {
      if (entry < entries || entry == TALWEG_NO_ENTRY) continue;
      bad(name, fmt::format("has the entry {} at triangle {}, and {} entries", entry, f, entries));
    }
  }
  return corners;
}

}  // namespace

HostAttributes::Attribute HostAttributes::copied(const talweg_attribute& given,
                                                 std::size_t vertices, std::size_t faces) {
  if (given.name == nullptr || *given.name == '\0') {
    throw plugin::Failure(TALWEG_BAD_USAGE, "An attribute has no name.");
  }
  Attribute result{given.name,
                   given.element,
                   given.carry,
                   given.values.columns,
                   given.values.type,
                   given.fill,
                   {},
                   given.corners.rows > 0,
                   {}};
  const std::string& name = result.name;
  if (given.element < TALWEG_OF_VERTICES || given.element > TALWEG_OF_CORNERS) {
    bad(name, fmt::format("is of the unknown element {}", given.element));
  }
  if (given.carry < TALWEG_CARRY_LINEAR || given.carry > TALWEG_CARRY_DIRECTION) {
    bad(name, fmt::format("has the unknown rule {}", given.carry));
  }
  if (result.columns < 1 || result.columns > 64) {
    bad(name, fmt::format("has {} columns, not 1 to 64", result.columns));
  }
  if (given.carry == TALWEG_CARRY_DIRECTION && result.columns != 3) {
    bad(name, fmt::format("is a direction and has {} columns, not 3", result.columns));
  }
  const bool at_corners = given.element == TALWEG_OF_CORNERS;
  const std::size_t rows = at_corners                            ? 3 * faces
                           : given.element == TALWEG_OF_VERTICES ? vertices
                                                                 : faces;
  if (!result.shared && given.values.rows != rows) {
    bad(name, fmt::format("has {} rows, not {}", given.values.rows, rows));
  }
  if (!std::isfinite(given.fill)) bad(name, "has a fill that is not finite");
  result.values =
      plugin::numbers_of(given.values, result.columns, "The attribute \"" + name + "\"");
  if (given.values.type == TALWEG_INT64 || given.values.type == TALWEG_UINT64) {
    for (const double value : result.values) {
      if (std::abs(value) < 9007199254740992.0) continue;
      bad(name, "has whole numbers of 2^53 or more; carry it by the origin");
    }
  }
  if (!at_corners && result.shared) bad(name, "has corners, and is not of corners");
  if (!at_corners) return result;
  if (result.shared) {
    result.corners = corners_of(given, faces, given.values.rows);
  } else {
    for (std::uint32_t f = 0; f < faces; ++f) {
      result.corners.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    }
  }
  return result;
}

void HostAttributes::set(std::span<const talweg_attribute* const> attributes, std::size_t vertices,
                         std::size_t faces) {
  std::vector<Attribute> all;
  std::set<std::pair<std::uint32_t, std::string>> names;
  for (const talweg_attribute* given : attributes) {
    const Attribute& attribute = all.emplace_back(copied(*given, vertices, faces));
    if (!names.emplace(attribute.element, attribute.name).second) {
      bad(attribute.name, "is there twice");
    }
  }
  attributes_ = std::move(all);
}

void HostAttributes::give(const CarryOver& carry_over, const plugin::TakeAttribute& take) const {
  MeshAttributes columns;
  for (const Attribute& a : attributes_) {
    if (a.element == TALWEG_OF_CORNERS) continue;
    auto& list = a.element == TALWEG_OF_VERTICES ? columns.vertices : columns.faces;
    for (std::uint32_t c = 0; c < a.columns; ++c) {
      AttributeColumn& column = list.emplace_back();
      column.name = a.name;
      column.carry = carry_of(a.rule);
      column.fill = a.fill;
      column.values.reserve(a.values.size() / a.columns);
      for (std::size_t k = c; k < a.values.size(); k += a.columns) {
        column.values.push_back(a.values[k]);
      }
    }
  }
  const MeshAttributes carried = carry_over(columns);
  std::size_t of_vertices = 0, of_faces = 0;
  for (const Attribute& a : attributes_) {
    if (a.element == TALWEG_OF_CORNERS) {
      MeshAttributes one;
      one.texture = {a.columns, a.values, a.corners, carry_of(a.rule)};
      give_corners(a, carry_over(one).texture, take);
    } else {
      const bool vertices = a.element == TALWEG_OF_VERTICES;
      std::size_t& first = vertices ? of_vertices : of_faces;
      give_columns(a, vertices ? carried.vertices : carried.faces, first, take);
      first += a.columns;
    }
  }
}

void HostAttributes::give_columns(const Attribute& attribute,
                                  const std::vector<AttributeColumn>& columns, std::size_t first,
                                  const plugin::TakeAttribute& take) {
  const std::size_t rows = columns[first].values.size();
  std::vector<double> values(rows * attribute.columns);
  for (std::uint32_t c = 0; c < attribute.columns; ++c) {
    const std::vector<double>& column = columns[first + c].values;
    for (std::size_t k = 0; k < rows; ++k) values[k * attribute.columns + c] = column[k];
  }
  const std::vector<char> bytes = bytes_of(values, attribute.type);
  take({sizeof(talweg_attribute), attribute.element, attribute.rule, 0, attribute.name.c_str(),
        attribute.fill, view_of(bytes, rows, attribute.columns, attribute.type), plugin::kNoArray});
}

void HostAttributes::give_corners(const Attribute& attribute, const CornerAttribute& carried,
                                  const plugin::TakeAttribute& take) {
  const std::uint32_t n = attribute.columns;
  bool shared = attribute.shared;
  for (const auto& corners : carried.corners) {
    for (const std::uint32_t entry : corners) shared = shared || entry == CornerAttribute::kNone;
  }
  std::vector<double> values;
  if (shared) {
    values = carried.values;
  } else {
    values.reserve(carried.corners.size() * 3 * n);
    for (const auto& corners : carried.corners) {
      for (const std::uint32_t entry : corners) {
        for (std::uint32_t c = 0; c < n; ++c) values.push_back(carried.values[entry * n + c]);
      }
    }
  }
  const std::vector<char> bytes = bytes_of(values, attribute.type);
  const std::uint32_t* first = carried.corners.empty() ? nullptr : carried.corners.front().data();
  take({sizeof(talweg_attribute), attribute.element, attribute.rule, 0, attribute.name.c_str(),
        attribute.fill, view_of(bytes, values.size() / n, n, attribute.type),
        shared ? plugin::view(first, carried.corners.size(), 3) : plugin::kNoArray});
}

void give_per_triangle(const char* name, const std::vector<double>& values, std::uint32_t type,
                       const plugin::TakeAttribute& take) {
  const std::vector<char> bytes = bytes_of(values, type);
  take({sizeof(talweg_attribute), TALWEG_OF_TRIANGLES, TALWEG_CARRY_NEAREST, 0, name, 0,
        view_of(bytes, values.size(), 1, type), plugin::kNoArray});
}

}  // namespace talweg::plugins
