// The properties of an OpenMesh mesh that can be attributes of the interface, with a sentence on
// each of the others.
#pragma once

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "talweg_meshes.h"
#include "talweg_openmesh_attributes.hpp"
#include "talweg_openmesh_mesh.hpp"
#include "talweg_openmesh_values.hpp"

namespace talweg::openmesh {

/// The prefix of Talweg's own properties, which hold the origin of vertices and faces.
inline constexpr std::string_view kOwnPrefix = "talweg:";

namespace detail {

inline std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The default rule for new elements, the same as in Talweg's other hosts.
inline std::uint32_t carry_of(const std::string& name, std::uint32_t type, std::uint32_t columns) {
  const std::string text = lower(name);
  const std::string last = text.substr(text.find(':') + 1);  // OpenMesh's own name is v:normals
  if (is_real(type) && columns == 3 && (last == "normal" || last == "normals")) {
    return TALWEG_CARRY_DIRECTION;
  }
  if (text.find("label") != std::string::npos) return TALWEG_CARRY_NEAREST;
  if (is_real(type)) return TALWEG_CARRY_LINEAR;
  return type == TALWEG_UINT8 ? TALWEG_CARRY_ROUNDED : TALWEG_CARRY_NEAREST;
}

/// The value on lids: white for colours, 0 for everything else.
inline double fill_of(const std::string& name, std::uint32_t type, std::uint32_t columns) {
  if (lower(name).find("col") == std::string::npos || columns < 3 || columns > 4) return 0;
  return type == TALWEG_UINT8 ? 255 : is_real(type) ? 1 : 0;
}

inline std::string shown_name(const std::string& element, const OpenMesh::BaseProperty& property) {
  return "The " + element + " property \"" + property.name() + "\"";
}

/// Describes a property. Returns why the property cannot be an attribute, or nothing if it can.
template <class Mesh>
std::optional<std::string> described(const Mesh& mesh, const MeshNumbers& numbers,
                                     const OpenMesh::BaseProperty& given,
                                     AttributeProperty& property) {
  property.access = access_to(given);
  if (property.access == nullptr) {
    const std::string type = given.get_storage_name();
    return "holds " + (type == "UnknownType" ? std::string("a type of its own") : type) +
           ", which is neither a number nor a row of numbers";
  }
  std::optional<std::uint32_t> columns;
  bool even = true;
  for_rows(mesh, numbers, property.element, [&](std::size_t element) {
    const std::uint32_t here = property.access->columns(given, element);
    even = even && (!columns || *columns == here);
    columns = here;
  });
  property.columns = columns.value_or(1);
  if (!even) return "has lists of different lengths";
  if (property.columns < 1 || property.columns > 64) {
    return "has " + std::to_string(property.columns) + " numbers in a row, not 1 to 64";
  }
  property.name = given.name();
  property.type = property.access->type;
  property.carry = carry_of(property.name, property.type, property.columns);
  property.fill = fill_of(property.name, property.type, property.columns);
  return std::nullopt;
}

/// Whether a property may be an attribute: points, status, Talweg's own and unnamed properties may
/// not.
inline bool may_be_attribute(const OpenMesh::BaseProperty* property) {
  if (property == nullptr) return false;
  const std::string& name = property->name();
  const bool is_status = name.size() == 8 && name.substr(1) == ":status";
  return !name.empty() && name[0] != '<' && name != "v:points" && !is_status &&
         name.rfind(kOwnPrefix, 0) != 0;
}

}  // namespace detail

/// All properties of a mesh that can be attributes, with OpenMesh's own except points and status.
/// Unnamed properties are left out. `left_out` gets a sentence on each named property that cannot
/// be an attribute.
template <class Mesh>
std::vector<AttributeProperty> properties_of(const Mesh& mesh, const MeshNumbers& numbers,
                                             std::vector<std::string>& left_out) {
  constexpr const char* kElements[] = {"vertex", "face", "halfedge"};
  std::vector<AttributeProperty> list;
  for (const std::uint32_t element : {TALWEG_OF_VERTICES, TALWEG_OF_TRIANGLES, TALWEG_OF_CORNERS}) {
    const auto [begin, end] = detail::properties_at(mesh, element);
    for (auto at = begin; at != end; ++at) {
      if (!detail::may_be_attribute(*at)) continue;
      AttributeProperty property;
      property.element = element;
      const auto problem = detail::described(mesh, numbers, **at, property);
      if (!problem) {
        list.push_back(std::move(property));
      } else {
        left_out.push_back(detail::shown_name(kElements[element - 1], **at) + " " + *problem + ".");
      }
    }
  }
  for (auto at = mesh.eprops_begin(); at != mesh.eprops_end(); ++at) {
    if (!detail::may_be_attribute(*at)) continue;
    left_out.push_back(detail::shown_name("edge", **at) + " has no counterpart in the interface.");
  }
  return list;
}

}  // namespace talweg::openmesh
