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

/// The bytes of values as numbers of a type (TALWEG_FLOAT32, ...).
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

/// The entries of the corners, which may be TALWEG_NO_ENTRY.
std::vector<std::array<std::uint32_t, 3>> corners_of(const talweg_attribute& given,
                                                     std::size_t faces, std::size_t entries) {
  const std::string name = given.name;
  plugin::check_array(given.corners, 3, "The corners of the attribute \"" + name + "\"");
  if (given.corners.rows != faces) {
    bad(name, fmt::format("has corners for {} triangles, but the mesh has {}", given.corners.rows,
                          faces));
  }
  if (given.corners.type != TALWEG_UINT32) bad(name, "has corners that are not 32-bit indices");
  std::vector<std::array<std::uint32_t, 3>> corners(faces);
  const auto* bytes = static_cast<const char*>(given.corners.data);
  const std::uint64_t stride = given.corners.stride == 0 ? 12 : given.corners.stride;
  for (std::size_t f = 0; f < faces; ++f) {
    std::memcpy(corners[f].data(), bytes + f * stride, sizeof corners[f]);
    for (const std::uint32_t entry : corners[f]) {
      if (entry < entries || entry == TALWEG_NO_ENTRY) continue;
      bad(name,
          fmt::format("has the entry {} at triangle {}, but only {} entries", entry, f, entries));
    }
  }
  return corners;
}

HostAttribute copied(const talweg_attribute& given, std::size_t vertices, std::size_t faces) {
  if (given.name == nullptr || *given.name == '\0') {
    throw plugin::Failure(TALWEG_BAD_USAGE, "An attribute has no name.");
  }
  HostAttribute result;
  result.name = given.name;
  result.element = given.element;
  result.rule = given.carry;
  result.columns = given.values.columns;
  result.type = given.values.type;
  result.fill = given.fill;
  result.shared = given.corners.rows > 0;
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
      bad(name,
          "has whole numbers of 2^53 or more, which are not carried exactly; transfer it with the "
          "origin of the new mesh instead");
    }
  }
  if (!at_corners && result.shared)
    bad(name, "has a list of corners, but does not belong to corners");
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

/// The attribute of a made mesh, with the values of its columns from `first` on.
HostAttribute with_columns(const HostAttribute& attribute,
                           const std::vector<AttributeColumn>& columns, std::size_t first) {
  HostAttribute result = attribute;
  const std::size_t rows = columns[first].values.size();
  result.values.resize(rows * attribute.columns);
  for (std::uint32_t c = 0; c < attribute.columns; ++c) {
    const std::vector<double>& column = columns[first + c].values;
    for (std::size_t k = 0; k < rows; ++k) result.values[k * attribute.columns + c] = column[k];
  }
  return result;
}

HostAttribute with_corners(const HostAttribute& attribute, CornerAttribute carried) {
  HostAttribute result = attribute;
  result.values = std::move(carried.values);
  result.corners = std::move(carried.corners);
  for (const auto& corners : result.corners) {
    for (const std::uint32_t entry : corners) {
      result.shared = result.shared || entry == CornerAttribute::kNone;
    }
  }
  return result;
}

/// The values of an attribute of corners, with a row for each corner.
std::vector<double> by_corner(const HostAttribute& attribute) {
  std::vector<double> values;
  values.reserve(attribute.corners.size() * 3 * attribute.columns);
  for (const auto& corners : attribute.corners) {
    for (const std::uint32_t entry : corners) {
      const double* row = &attribute.values[std::size_t{entry} * attribute.columns];
      values.insert(values.end(), row, row + attribute.columns);
    }
  }
  return values;
}

}  // namespace

std::uint32_t rule_of(Carry carry) {
  switch (carry) {
    case Carry::kRounded:
      return TALWEG_CARRY_ROUNDED;
    case Carry::kNearest:
      return TALWEG_CARRY_NEAREST;
    case Carry::kDirection:
      return TALWEG_CARRY_DIRECTION;
    default:
      return TALWEG_CARRY_LINEAR;
  }
}

AttributeView::AttributeView(const HostAttribute& attribute) {
  const bool by_row = attribute.element == TALWEG_OF_CORNERS && !attribute.shared;
  bytes_ = bytes_of(by_row ? by_corner(attribute) : attribute.values, attribute.type);
  const std::size_t rows =
      by_row ? 3 * attribute.corners.size() : attribute.values.size() / attribute.columns;
  const bool with_entries = attribute.shared && !attribute.corners.empty();
  view_ = {sizeof view_,
           attribute.element,
           attribute.rule,
           0,
           attribute.name.c_str(),
           attribute.fill,
           {bytes_.data(), rows, 0, attribute.columns, attribute.type},
           with_entries
               ? plugin::view(attribute.corners.front().data(), attribute.corners.size(), 3)
               : plugin::kNoArray};
}

void HostAttributes::set(std::span<const talweg_attribute* const> attributes, std::size_t vertices,
                         std::size_t faces) {
  std::vector<HostAttribute> all;
  std::set<std::pair<std::uint32_t, std::string>> names;
  for (const talweg_attribute* given : attributes) {
    const HostAttribute& attribute = all.emplace_back(copied(*given, vertices, faces));
    if (!names.emplace(attribute.element, attribute.name).second) {
      bad(attribute.name, "is given twice");
    }
  }
  attributes_ = std::move(all);
}

bool HostAttributes::at_corners() const {
  return std::any_of(attributes_.begin(), attributes_.end(),
                     [](const auto& a) { return a.element == TALWEG_OF_CORNERS; });
}

void HostAttributes::give(const CarryOver& carry_over, const plugin::TakeAttribute& take) const {
  MeshAttributes columns;
  for (const HostAttribute& a : attributes_) {
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
  for (const HostAttribute& a : attributes_) {
    if (a.element == TALWEG_OF_CORNERS) {
      MeshAttributes one;
      one.texture = {a.columns, a.values, a.corners, carry_of(a.rule)};
      take(AttributeView(with_corners(a, carry_over(one).texture)).view());
    } else {
      const bool vertices = a.element == TALWEG_OF_VERTICES;
      std::size_t& first = vertices ? of_vertices : of_faces;
      const auto& from = vertices ? carried.vertices : carried.faces;
      take(AttributeView(with_columns(a, from, first)).view());
      first += a.columns;
    }
  }
}

void give_per_triangle(const char* name, const std::vector<double>& values, std::uint32_t type,
                       const plugin::TakeAttribute& take) {
  HostAttribute attribute;
  attribute.name = name;
  attribute.element = TALWEG_OF_TRIANGLES;
  attribute.rule = TALWEG_CARRY_NEAREST;
  attribute.type = type;
  attribute.values = values;
  take(AttributeView(attribute).view());
}

}  // namespace talweg::plugins
