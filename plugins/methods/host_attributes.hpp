// Host attributes are copies of the attributes that a host gives with a mesh (talweg_meshes.h).
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

/// The TALWEG_CARRY_... constant.
std::uint32_t rule_of(Carry carry);

/// Converts attributes of the host's mesh to another mesh, by carried_to() and picked().
using CarryOver = std::function<MeshAttributes(const MeshAttributes& attributes)>;

struct HostAttribute {
  std::string name;
  std::uint32_t element = TALWEG_OF_VERTICES, rule = TALWEG_CARRY_LINEAR, columns = 1;
  std::uint32_t type = TALWEG_FLOAT64;  ///< of the host's numbers
  double fill = 0;
  std::vector<double> values;                         ///< row by row
  bool shared = false;                                ///< corners share entries, or have none
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< for corners: the entry of each
};

/// A view of an attribute in its own type, as the interface has it. Corners that do not share
/// entries are written row by row. The attribute must outlive its view, which must not be moved.
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
  /// Copies the attributes. Throws plugin::Failure(TALWEG_BAD_USAGE) naming the attribute: for a
  /// name that is empty or repeated, an unknown element or rule, a wrong number of rows, columns
  /// outside 1 to 64, whole numbers from 2^53, and corners that name no entry.
  void set(std::span<const talweg_attribute* const> attributes, std::size_t vertices,
           std::size_t faces);
  void clear() { attributes_.clear(); }
  [[nodiscard]] const std::vector<HostAttribute>& all() const { return attributes_; }
  [[nodiscard]] bool at_corners() const;  ///< whether there are attributes of corners

  /// Gives all attributes to the host, converted to another mesh, in their original types.
  void give(const CarryOver& carry_over, const plugin::TakeAttribute& take) const;

 private:
  std::vector<HostAttribute> attributes_;
};

/// Gives one number per triangle, as an attribute made by the plugin.
void give_per_triangle(const char* name, const std::vector<double>& values, std::uint32_t type,
                       const plugin::TakeAttribute& take);

}  // namespace talweg::plugins
