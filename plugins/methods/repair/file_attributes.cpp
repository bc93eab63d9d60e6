#include "file_attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/cutting/attribute_transfer.hpp"

namespace talweg::plugins {
namespace {

using Names = std::vector<std::string_view>;

constexpr std::string_view kNormal = "normals", kColour = "colors", kTexture = "uv";

constexpr std::array<std::pair<NumberType, std::uint32_t>, 10> kTypes{
    {{NumberType::kInt8, TALWEG_INT8},
     {NumberType::kUint8, TALWEG_UINT8},
     {NumberType::kInt16, TALWEG_INT16},
     {NumberType::kUint16, TALWEG_UINT16},
     {NumberType::kInt32, TALWEG_INT32},
     {NumberType::kUint32, TALWEG_UINT32},
     {NumberType::kInt64, TALWEG_INT64},
     {NumberType::kUint64, TALWEG_UINT64},
     {NumberType::kFloat32, TALWEG_FLOAT32},
     {NumberType::kFloat64, TALWEG_FLOAT64}}};

std::uint32_t type_of(NumberType type) { return kTypes[static_cast<std::size_t>(type)].second; }

NumberType type_of(std::uint32_t type) {
  const auto* found = std::find_if(kTypes.begin(), kTypes.end(),
                                   [&](const auto& pair) { return pair.second == type; });
  return found == kTypes.end() ? NumberType::kFloat64 : found->first;
}

bool is_real(NumberType type) {
  return type == NumberType::kFloat32 || type == NumberType::kFloat64;
}

/// Names of attributes and of their columns in files. The first entry whose columns a file has
/// counts.
const std::vector<std::pair<std::string_view, Names>>& known_groups() {
  static const std::vector<std::pair<std::string_view, Names>> kGroups{
      {kNormal, {kNormals.begin(), kNormals.end()}},
      {kColour, {kColours.begin(), kColours.end()}},
      {kColour, {kColours.begin(), kColours.begin() + 3}},
      {kTexture, {"s", "t"}},
      {kTexture, {"u", "v"}},
      {kTexture, {"texture_u", "texture_v"}}};
  return kGroups;
}

struct Group {
  std::string name;
  std::vector<std::size_t> columns;
};

class Grouping {
 public:
  explicit Grouping(const std::vector<AttributeColumn>& columns)
      : columns_(columns), taken_(columns.size(), false) {
    for (std::size_t c = 0; c < columns.size(); ++c) places_.emplace(columns[c].name, c);
    for (const auto& [name, of] : known_groups()) take_known(std::string(name), of);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!taken_[c]) take_from(c);
    }
    std::stable_sort(groups_.begin(), groups_.end(), [](const Group& a, const Group& b) {
      return a.columns.front() < b.columns.front();
    });
  }
  [[nodiscard]] std::vector<Group> groups() && { return std::move(groups_); }

 private:
  void take_known(const std::string& name, const Names& of) {
    std::vector<std::size_t> found;
    for (const std::string_view column : of) {
      const auto at = places_.find(column);
      if (at == places_.end() || taken_[at->second]) return;
      found.push_back(at->second);
    }
    if (places_.contains(name) || !names_.insert(name).second || !alike(found)) return;
    if (name == kNormal && !is_real(columns_[found.front()].type)) return;
    take({name, found});
  }

  /// Groups a column NAME_0 with the columns NAME_1, NAME_2, ... after it; other columns stay
  /// alone.
  void take_from(std::size_t c) {
    const std::string& first = columns_[c].name;
    Group group{first, {c}};
    if (first.size() > 2 && first.ends_with("_0")) {
      const std::string name = first.substr(0, first.size() - 2);
      while (c + group.columns.size() < columns_.size() && group.columns.size() < kMost) {
        const std::size_t next = c + group.columns.size();
        if (columns_[next].name != fmt::format("{}_{}", name, group.columns.size())) break;
        group.columns.push_back(next);
      }
      const bool free = !places_.contains(name) && !names_.contains(name);
      if (group.columns.size() > 1 && free && alike(group.columns)) {
        group.name = name;
      } else {
        group.columns.resize(1);
      }
    }
    names_.insert(group.name);
    take(std::move(group));
  }

  void take(Group group) {
    for (const std::size_t c : group.columns) taken_[c] = true;
    groups_.push_back(std::move(group));
  }

  [[nodiscard]] bool alike(const std::vector<std::size_t>& columns) const {
    return std::all_of(columns.begin(), columns.end(), [&](std::size_t c) {
      return columns_[c].type == columns_[columns.front()].type;
    });
  }

  static constexpr std::size_t kMost = 64;
  const std::vector<AttributeColumn>& columns_;
  std::vector<bool> taken_;
  std::map<std::string_view, std::size_t> places_;
  std::set<std::string> names_;
  std::vector<Group> groups_;
};

void add_groups(const std::vector<AttributeColumn>& columns, std::uint32_t element,
                std::vector<HostAttribute>& all) {
  for (const Group& group : Grouping(columns).groups()) {
    const AttributeColumn& first = columns[group.columns.front()];
    HostAttribute& to = all.emplace_back();
    to.name = group.name;
    to.element = element;
    const bool direction = group.name == kNormal && group.columns.size() == 3;
    to.rule = rule_of(direction ? Carry::kDirection : carry_of(first));
    to.columns = static_cast<std::uint32_t>(group.columns.size());
    to.type = type_of(first.type);
    to.fill = fill_of(first);
    to.values.reserve(first.values.size() * to.columns);
    for (std::size_t k = 0; k < first.values.size(); ++k) {
      for (const std::size_t c : group.columns) to.values.push_back(columns[c].values[k]);
    }
  }
}

void add_corners(const CornerAttribute& corners, std::string_view name, std::uint32_t rule,
                 std::vector<HostAttribute>& all) {
  if (corners.dimension == 0) return;
  HostAttribute& to = all.emplace_back();
  to.name = name;
  to.element = TALWEG_OF_CORNERS;
  to.rule = rule;
  to.columns = static_cast<std::uint32_t>(corners.dimension);
  to.values = corners.values;
  to.shared = true;
  to.corners = corners.corners;
}

/// Makes names of columns without blanks, all different, and none of them x, y or z.
class ColumnNames {
 public:
  std::string operator()(const std::string& wanted) {
    std::string name = wanted;
    for (char& c : name) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte <= ' ' || byte == 0x7F) c = '_';
    }
    while (!used_.insert(name).second) name += '_';
    return name;
  }

 private:
  std::set<std::string> used_{"x", "y", "z"};
};

Names names_of_columns(const HostAttribute& attribute) {
  const auto matches = [&](const auto& known) {
    return known.first == attribute.name && known.second.size() == attribute.columns;
  };
  const auto& all = known_groups();
  const auto found = std::find_if(all.begin(), all.end(), matches);
  return found == all.end() ? Names{} : found->second;
}

void add_columns(const HostAttribute& attribute, ColumnNames& names,
                 std::vector<AttributeColumn>& columns) {
  const Names known = names_of_columns(attribute);
  for (std::uint32_t c = 0; c < attribute.columns; ++c) {
    AttributeColumn& to = columns.emplace_back();
    if (!known.empty()) {
      to.name = names(std::string(known[c]));
    } else {
      to.name =
          names(attribute.columns == 1 ? attribute.name : fmt::format("{}_{}", attribute.name, c));
    }
    to.type = type_of(attribute.type);
    to.values.reserve(attribute.values.size() / attribute.columns);
    for (std::size_t k = c; k < attribute.values.size(); k += attribute.columns) {
      to.values.push_back(attribute.values[k]);
    }
  }
}

using Row = std::array<double, 3>;

struct HashOfRow {
  std::size_t operator()(const Row& row) const {
    std::size_t hash = 0;
    for (const double x : row) hash = hash * 1000003 + std::hash<double>()(x);
    return hash;
  }
};

/// Corners with the same numbers share an entry. A corner with a number that is not finite has
/// none.
CornerAttribute shared_corners(const HostAttribute& attribute) {
  const std::uint32_t columns = attribute.columns;
  if (attribute.shared) return {columns, attribute.values, attribute.corners};
  CornerAttribute result;
  result.dimension = columns;
  std::unordered_map<Row, std::uint32_t, HashOfRow> entries;
  for (const auto& corners : attribute.corners) {
    auto& own = result.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      own[k] = CornerAttribute::kNone;
      Row row{};
      std::copy_n(&attribute.values[std::size_t{corners[k]} * columns], columns, row.begin());
      if (!std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); })) continue;
      const auto next = static_cast<std::uint32_t>(entries.size());
      const auto [entry, fresh] = entries.emplace(row, next);
      own[k] = entry->second;
      if (fresh) result.values.insert(result.values.end(), row.begin(), row.begin() + columns);
    }
  }
  return result;
}

}  // namespace

std::vector<HostAttribute> grouped(const MeshAttributes& attributes) {
  std::vector<HostAttribute> all;
  add_groups(attributes.vertices, TALWEG_OF_VERTICES, all);
  add_groups(attributes.faces, TALWEG_OF_TRIANGLES, all);
  add_corners(attributes.texture, kTexture, TALWEG_CARRY_LINEAR, all);
  add_corners(attributes.normals, kNormal, TALWEG_CARRY_DIRECTION, all);
  for (const FaceNames& names : attributes.names) {
    HostAttribute& to = all.emplace_back();
    to.name = names.keyword;
    to.element = TALWEG_OF_TRIANGLES;
    to.rule = TALWEG_CARRY_NEAREST;
    to.type = TALWEG_UINT32;
    to.values.assign(names.of_face.begin(), names.of_face.end());
  }
  return all;
}

MeshAttributes in_columns(const std::vector<HostAttribute>& attributes,
                          std::vector<std::string>& left_out) {
  MeshAttributes result;
  ColumnNames of_vertices, of_faces;
  for (const HostAttribute& attribute : attributes) {
    if (attribute.element == TALWEG_OF_VERTICES) {
      add_columns(attribute, of_vertices, result.vertices);
    } else if (attribute.element == TALWEG_OF_TRIANGLES) {
      add_columns(attribute, of_faces, result.faces);
    } else if (attribute.name == kTexture && (attribute.columns == 2 || attribute.columns == 3)) {
      result.texture = shared_corners(attribute);
    } else if (attribute.name == kNormal && attribute.columns == 3) {
      result.normals = shared_corners(attribute);
    } else {
      left_out.push_back(fmt::format("'{}' of corners", attribute.name));
    }
  }
  return result;
}

}  // namespace talweg::plugins
