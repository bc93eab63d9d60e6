// Host attributes are the values that a host gives with a mesh (talweg_meshes.h), in our own
// memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// How attributes of the mesh that came in become those of another: by carried_to() and picked().
using CarryOver = std::function<MeshAttributes(const MeshAttributes& attributes)>;

class HostAttributes {
 public:
  /// Copies them. Throws plugin::Failure(TALWEG_BAD_USAGE) naming the attribute: for a name that is
  /// empty or there twice, an unknown element or rule, rows that do not fit, columns beyond 1 to
  /// 64, whole numbers from 2^53, and corners that name no entry.
  void set(std::span<const talweg_attribute* const> attributes, std::size_t vertices,
           std::size_t faces);
  void clear() { attributes_.clear(); }

  /// Gives all of them, carried over, in the types that they came in.
  void give(const CarryOver& carry_over, const plugin::TakeAttribute& take) const;

 private:
  struct Attribute {
    std::string name;
    std::uint32_t element, rule, columns, type;
    double fill;
    std::vector<double> values;
    bool shared;  // came in with corners
    std::vector<std::array<std::uint32_t, 3>> corners;
  };
  static Attribute copied(const talweg_attribute& given, std::size_t vertices, std::size_t faces);
  static void give_columns(const Attribute& attribute, const std::vector<AttributeColumn>& columns,
                           std::size_t first, const plugin::TakeAttribute& take);
  static void give_corners(const Attribute& attribute, const CornerAttribute& carried,
                           const plugin::TakeAttribute& take);

  std::vector<Attribute> attributes_;
};

/// Gives one number for each triangle, as an attribute of theirs that the plugin makes.
void give_per_triangle(const char* name, const std::vector<double>& values, std::uint32_t type,
                       const plugin::TakeAttribute& take);

}  // namespace talweg::plugins
