#include "plugin_attributes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/cutting/attribute_transfer.hpp"

namespace talweg::driver {
namespace {

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

/// The indices of the three columns of normals, if the mesh has normals that are real numbers.
std::optional<std::array<std::size_t, 3>> normals_among(
    const std::vector<AttributeColumn>& columns) {
  std::array<std::size_t, 3> places{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const AttributeColumn& c) {
      const bool real = c.type == NumberType::kFloat32 || c.type == NumberType::kFloat64;
      return real && c.name == kNormals[k];
    });
    if (found == columns.end()) return std::nullopt;
    places[k] = static_cast<std::size_t>(found - columns.begin());
  }
  return places;
}

/// Groups of columns that are carried together, as the indices of their columns.
std::vector<std::vector<std::size_t>> groups_of(const std::vector<AttributeColumn>& columns,
                                                bool with_normals) {
  const auto normals = with_normals ? normals_among(columns) : std::nullopt;
  std::vector<std::vector<std::size_t>> groups;
  if (normals) groups.emplace_back(normals->begin(), normals->end());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const bool taken = normals && std::find(normals->begin(), normals->end(), c) != normals->end();
    if (!taken) groups.push_back({c});
  }
  return groups;
}

/// A name that no other attribute has.
std::string name_of(std::size_t number, const std::string& name) {
  return fmt::format("{} {}", number, name);
}

void add_columns(const std::vector<AttributeColumn>& columns, std::uint32_t element,
                 std::vector<host::Attribute>& all) {
  for (const auto& group : groups_of(columns, element == TALWEG_OF_VERTICES)) {
    const AttributeColumn& first = columns[group.front()];
    host::Attribute& to = all.emplace_back();
    to.name = name_of(all.size(), first.name);
    to.element = element;
    to.carry = rule_of(group.size() == 3 ? Carry::kDirection : carry_of(first));
    to.fill = fill_of(first);
    to.columns = static_cast<std::uint32_t>(group.size());
    for (std::size_t k = 0; k < first.values.size(); ++k) {
      for (const std::size_t c : group) to.values.push_back(columns[c].values[k]);
    }
  }
}

void add_corners(const CornerAttribute& corners, std::uint32_t carry,
                 std::vector<host::Attribute>& all) {
  if (corners.dimension == 0) return;
  host::Attribute& to = all.emplace_back();
  to.name = name_of(all.size(), "corners");
  to.element = TALWEG_OF_CORNERS;
  to.carry = carry;
  to.columns = static_cast<std::uint32_t>(corners.dimension);
  to.values = corners.values;
  to.corners = corners.corners;
}

class FileAttributes {
 public:
  FileAttributes(const MeshAttributes& from, const std::vector<host::Attribute>& carried)
      : from_(from), next_(carried.begin()), end_(carried.end()) {}

  MeshAttributes run() {
    MeshAttributes result;
    result.references = from_.references;
    result.left_out = from_.left_out;
    take_columns(from_.vertices, true, result.vertices);
    take_columns(from_.faces, false, result.faces);
    take_corners(from_.texture, result.texture);
    take_corners(from_.normals, result.normals);
    for (const FaceNames& names : from_.names) {
      FaceNames& to = result.names.emplace_back(FaceNames{names.keyword, names.names, {}});
      for (const double value : (next_++)->values) {
        to.of_face.push_back(static_cast<std::uint32_t>(value));
      }
    }
    for (; next_ != end_; ++next_) add_own(*next_, result);
    return result;
  }

 private:
  void take_columns(const std::vector<AttributeColumn>& columns, bool with_normals,
                    std::vector<AttributeColumn>& to) {
    for (const AttributeColumn& column : columns) {
      to.push_back({column.name, column.type, {}, column.carry, column.fill});
    }
    for (const auto& group : groups_of(columns, with_normals)) {
      const std::vector<double>& values = (next_++)->values;
      for (std::size_t k = 0; k < values.size(); ++k) {
        to[group[k % group.size()]].values.push_back(values[k]);
      }
    }
  }
  void take_corners(const CornerAttribute& corners, CornerAttribute& to) {
    if (corners.dimension == 0) return;
    to = {corners.dimension, next_->values, next_->corners, corners.carry};
    ++next_;
  }
  /// An attribute that the plugin made.
  static void add_own(const host::Attribute& own, MeshAttributes& to) {
    if (own.columns != 1 || own.element == TALWEG_OF_CORNERS) return;
    auto& columns = own.element == TALWEG_OF_VERTICES ? to.vertices : to.faces;
    std::erase_if(columns, [&](const AttributeColumn& column) { return column.name == own.name; });
    const bool whole = std::all_of(own.values.begin(), own.values.end(), [](double value) {
      return value == std::floor(value) && std::abs(value) <= 2147483647.0;
    });
    columns.push_back({own.name, whole ? NumberType::kInt32 : NumberType::kFloat64, own.values});
  }

  const MeshAttributes& from_;
  std::vector<host::Attribute>::const_iterator next_, end_;
};

}  // namespace

std::vector<host::Attribute> host_attributes(const MeshAttributes& attributes) {
  std::vector<host::Attribute> all;
  add_columns(attributes.vertices, TALWEG_OF_VERTICES, all);
  add_columns(attributes.faces, TALWEG_OF_TRIANGLES, all);
  add_corners(attributes.texture, TALWEG_CARRY_LINEAR, all);
  add_corners(attributes.normals, TALWEG_CARRY_DIRECTION, all);
  for (const FaceNames& names : attributes.names) {
    host::Attribute& to = all.emplace_back();
    to.name = name_of(all.size(), names.keyword);
    to.element = TALWEG_OF_TRIANGLES;
    to.carry = TALWEG_CARRY_NEAREST;
    to.values.assign(names.of_face.begin(), names.of_face.end());
  }
  return all;
}

MeshAttributes file_attributes(const MeshAttributes& attributes,
                               const std::vector<host::Attribute>& carried) {
  // A plugin returns attributes in the order of the input: vertices, triangles, corners, names.
  return FileAttributes(attributes, carried).run();
}

}  // namespace talweg::driver
