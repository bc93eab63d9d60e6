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

/// TALWEG_CARRY_...
std::uint32_t rule_of(Carry carry);

/// How attributes of the mesh that came in become those of another: by carried_to() and picked().
using CarryOver = std::function<MeshAttributes(const MeshAttributes& attributes)>;

struct HostAttribute {
  std::string name;
  std::uint32_t element = TALWEG_OF_VERTICES, rule = TALWEG_CARRY_LINEAR, columns = 1;
  std::uint32_t type = TALWEG_FLOAT64;  ///< of the host's numbers
  double fill = 0;
  std::vector<double> values;                         ///< row by row
  bool shared = false;                                ///< corners share entries, or have none
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< of corners only: entries
};

/// An attribute in its type, as the interface has it. Corners that do not share entries are there
/// row by row. The attribute must outlive its view, which is not moved.
class AttributeView {
 public:
  explicit AttributeView(const HostAttribute& attribute);
  AttributeView(const AttributeView&) = delete;
  AttributeView& operator=(const AttributeView&) = delete;
  [[nodiscard]] const talweg_attribute& view() const { return view_; }

 private:
  std::vector<char> bytes_;
  talweg_attribute view_ = {};
};

class HostAttributes {
 public:
  /// Copies them. Throws plugin::Failure(TALWEG_BAD_USAGE) naming the attribute: for a name that is
  /// empty or there twice, an unknown element or rule, rows that do not fit, columns beyond 1 to
  /// 64, whole numbers from 2^53, and corners that name no entry.
  void set(std::span<const talweg_attribute* const> attributes, std::size_t vertices,
           std::size_t faces);
  void clear() { attributes_.clear(); }
  [[nodiscard]] const std::vector<HostAttribute>& all() const { return attributes_; }
  [[nodiscard]] bool at_corners() const;  ///< whether some are of corners

  /// Gives all of them, carried over, in the types that they came in.
  void give(const CarryOver& carry_over, const plugin::TakeAttribute& take) const;

 private:
  std::vector<HostAttribute> attributes_;
};

/// Gives one number for each triangle, as an attribute of theirs that the plugin makes.
void give_per_triangle(const char* name, const std::vector<double>& values, std::uint32_t type,
                       const plugin::TakeAttribute& take);

}  // namespace talweg::plugins
