// Attributes of the interface (talweg_meshes.h) as OpenMesh properties: attributes of vertices and
// triangles as properties of vertices and faces, attributes of corners as properties of the
// halfedges that point to the corners.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "talweg_meshes.h"
#include "talweg_openmesh_mesh.hpp"
#include "talweg_openmesh_values.hpp"

namespace talweg::openmesh {

/// A property that is passed as an attribute.
struct AttributeProperty {
  std::string name;
  std::uint32_t element = TALWEG_OF_VERTICES;
  std::uint32_t carry = TALWEG_CARRY_LINEAR;
  double fill = 0;
  std::uint32_t columns = 1;
  std::uint32_t type = TALWEG_FLOAT64;
  bool shared = false;  ///< of corners with shared entries
  const detail::Access* access = nullptr;
};

/// An attribute that owns its memory.
struct OwnedAttribute {
  std::string name;
  std::uint32_t element, carry;
  double fill;
  std::uint32_t columns, type;
  std::vector<char> values;
  std::vector<std::uint32_t> corners;

  [[nodiscard]] talweg_attribute view() const {
    const std::uint64_t row = columns * plugin::detail::size_of(type);
    return {
        sizeof(talweg_attribute),
        element,
        carry,
        0,
        name.c_str(),
        fill,
        {values.data(), values.size() / row, 0, columns, type},
        corners.empty() ? plugin::kNoArray : plugin::view(corners.data(), corners.size() / 3, 3)};
  }
};

namespace detail {

template <class Number>
void append_number(double value, std::vector<char>& bytes) {
  const auto number = static_cast<Number>(value);
  const auto* first = reinterpret_cast<const char*>(&number);
  bytes.insert(bytes.end(), first, first + sizeof number);
}

inline void append_number(double value, std::uint32_t type, std::vector<char>& bytes) {
  switch (type) {
    case TALWEG_FLOAT32:
      return append_number<float>(value, bytes);
    case TALWEG_INT8:
      return append_number<std::int8_t>(value, bytes);
    case TALWEG_UINT8:
      return append_number<std::uint8_t>(value, bytes);
    case TALWEG_INT16:
      return append_number<std::int16_t>(value, bytes);
    case TALWEG_UINT16:
      return append_number<std::uint16_t>(value, bytes);
    case TALWEG_INT32:
      return append_number<std::int32_t>(value, bytes);
    case TALWEG_UINT32:
      return append_number<std::uint32_t>(value, bytes);
    case TALWEG_INT64:
      return append_number<std::int64_t>(value, bytes);
    case TALWEG_UINT64:
      return append_number<std::uint64_t>(value, bytes);
    default:
      return append_number<double>(value, bytes);
  }
}

inline bool is_real(std::uint32_t type) { return type == TALWEG_FLOAT64 || type == TALWEG_FLOAT32; }

/// Calls `use` with the index of each halfedge, vertex or face that an attribute has a row for, in
/// the order of the rows.
template <class Mesh, class Use>
void for_rows(const Mesh& mesh, const MeshNumbers& numbers, std::uint32_t element, const Use& use) {
  if (element == TALWEG_OF_VERTICES) {
    for (std::size_t k = 0; k < numbers.vertices.size(); ++k) {
      use(static_cast<std::size_t>(numbers.vertices.handle(k).idx()));
    }
    return;
  }
  for (std::size_t k = 0; k < numbers.faces.size(); ++k) {
    const FaceHandle f = numbers.faces.handle(k);
    if (element == TALWEG_OF_TRIANGLES) {
      use(static_cast<std::size_t>(f.idx()));
    } else {
      for (const HalfedgeHandle h : corner_halfedges(mesh, f))
        use(static_cast<std::size_t>(h.idx()));
    }
  }
}

/// Entries of an attribute of corners: equal values at a vertex share an entry, and NaN is not an
/// entry.
class Entries {
 public:
  explicit Entries(std::size_t vertices) : first_(vertices, TALWEG_NO_ENTRY) {}

  std::uint32_t of(const double* row, std::uint32_t columns, std::uint32_t vertex) {
    if (std::isnan(row[0])) return TALWEG_NO_ENTRY;
    for (std::uint32_t e = first_[vertex]; e != TALWEG_NO_ENTRY; e = next_[e]) {
      if (std::equal(row, row + columns, &rows_[std::size_t{e} * columns])) return e;
    }
    const auto entry = static_cast<std::uint32_t>(next_.size());
    rows_.insert(rows_.end(), row, row + columns);
    next_.push_back(first_[vertex]);
    return first_[vertex] = entry;
  }
  [[nodiscard]] const std::vector<double>& rows() const { return rows_; }

 private:
  std::vector<std::uint32_t> first_, next_;
  std::vector<double> rows_;
};

}  // namespace detail

/// The property's values on a mesh as an attribute of the interface. If the mesh does not have the
/// property, all rows get the fill value.
template <class Mesh>
OwnedAttribute attribute_of(const Mesh& mesh, const MeshNumbers& numbers,
                            const AttributeProperty& property) {
  OwnedAttribute result{property.name,
                        property.element,
                        property.carry,
                        property.fill,
                        property.columns,
                        property.type,
                        {},
                        {}};
  std::vector<double> row(property.columns, property.fill);
  const OpenMesh::BaseProperty* const values =
      detail::find_property(mesh, property.element, property.name, *property.access);
  const auto read = [&](std::size_t element) {
    if (values == nullptr) return;
    std::fill(row.begin(), row.end(), property.fill);  // a row of a list may be shorter
    property.access->get(*values, element, row.data(), property.columns);
  };
  bool shared = property.shared;
  if (property.element == TALWEG_OF_CORNERS && !shared) {
    detail::for_rows(mesh, numbers, property.element, [&](std::size_t element) {
      read(element);
      shared = shared || std::isnan(row[0]);
    });
  }
  if (!shared) {
    detail::for_rows(mesh, numbers, property.element, [&](std::size_t element) {
      read(element);
      for (const double value : row) detail::append_number(value, property.type, result.values);
    });
    return result;
  }
  detail::Entries entries(mesh.n_vertices());
  detail::for_rows(mesh, numbers, property.element, [&](std::size_t element) {
    read(element);
    const VertexHandle v = mesh.to_vertex_handle(HalfedgeHandle(static_cast<int>(element)));
    result.corners.push_back(
        entries.of(row.data(), property.columns, static_cast<std::uint32_t>(v.idx())));
  });
  for (const double value : entries.rows()) {
    detail::append_number(value, property.type, result.values);
  }
  return result;
}

namespace detail {

[[noreturn]] inline void bad_attribute(const std::string& name, const std::string& problem) {
  throw plugin::Failure(TALWEG_BAD_USAGE, "The attribute \"" + name + "\" " + problem + ".");
}

/// The row of each corner, or TALWEG_NO_ENTRY.
inline std::vector<std::uint32_t> entries_of(const talweg_attribute& attribute, std::size_t faces) {
  const std::string name = attribute.name;
  const talweg_array& given = attribute.corners;
  plugin::check_array(given, 3, "The corners of the attribute \"" + name + "\"");
  if (given.rows != faces) {
    bad_attribute(name, "has corners for " + std::to_string(given.rows) +
                            " triangles, but the mesh has " + std::to_string(faces));
  }
  if (given.type != TALWEG_UINT32) bad_attribute(name, "has corners that are not 32-bit indices");
  std::vector<std::uint32_t> entries(3 * faces);
  const std::size_t stride = given.stride == 0 ? 12 : static_cast<std::size_t>(given.stride);
  for (std::size_t f = 0; f < faces; ++f) {
    std::memcpy(&entries[3 * f], static_cast<const char*>(given.data) + f * stride, 12);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t entry = entries[3 * f + k];
      if (entry < attribute.values.rows) continue;
      if (entry == TALWEG_NO_ENTRY && is_real(attribute.values.type)) continue;
      bad_attribute(name,
                    entry == TALWEG_NO_ENTRY
                        ? "has whole numbers and a corner without an entry; only real numbers "
                          "may lack entries"
                        : "has the entry " + std::to_string(entry) + " at triangle " +
                              std::to_string(f) + ", but only " +
                              std::to_string(attribute.values.rows) + " entries");
    }
  }
  return entries;
}

inline AttributeProperty described(const talweg_attribute& given) {
  if (given.name == nullptr || *given.name == '\0') {
    throw plugin::Failure(TALWEG_BAD_USAGE, "An attribute has no name.");
  }
  AttributeProperty property{
      given.name,        given.element,          given.carry, given.fill, given.values.columns,
      given.values.type, given.corners.rows > 0, nullptr};
  if (given.element < TALWEG_OF_VERTICES || given.element > TALWEG_OF_CORNERS) {
    bad_attribute(given.name, "is of the unknown element " + std::to_string(given.element));
  }
  if (given.carry < TALWEG_CARRY_LINEAR || given.carry > TALWEG_CARRY_DIRECTION) {
    bad_attribute(given.name, "has the unknown rule " + std::to_string(given.carry));
  }
  if (property.columns < 1 || property.columns > 64) {
    bad_attribute(given.name, "has " + std::to_string(property.columns) + " columns, not 1 to 64");
  }
  if (property.shared && given.element != TALWEG_OF_CORNERS) {
    bad_attribute(given.name, "has a list of corners, but does not belong to corners");
  }
  if (property.name == "v:points") bad_attribute(given.name, "has the name of OpenMesh's points");
  if (plugin::detail::size_of(property.type) == 0) {
    bad_attribute(given.name, "has the unknown type " + std::to_string(property.type));
  }
  property.access = &access(property.type, property.columns);
  return property;
}

}  // namespace detail

/// Writes an attribute to a property of a mesh whose handles equal the interface's indices. A
/// property of this name and type is reused, otherwise one is added. Throws
/// plugin::Failure(TALWEG_BAD_USAGE) for an attribute that cannot be read or cannot be a property.
template <class Mesh>
AttributeProperty add_property(Mesh& mesh, const talweg_attribute& attribute) {
  AttributeProperty property = detail::described(attribute);
  const std::string& name = property.name;
  const std::size_t rows = property.element == TALWEG_OF_VERTICES    ? mesh.n_vertices()
                           : property.element == TALWEG_OF_TRIANGLES ? mesh.n_faces()
                                                                     : 3 * mesh.n_faces();
  if (!property.shared && attribute.values.rows != rows) {
    detail::bad_attribute(name, "has " + std::to_string(attribute.values.rows) + " rows, not " +
                                    std::to_string(rows));
  }
  std::vector<double> values =
      plugin::numbers_of(attribute.values, property.columns, "The attribute \"" + name + "\"");
  for (const double value : values) {
    if (detail::is_real(property.type) || std::abs(value) < 9007199254740992.0) continue;
    detail::bad_attribute(name, "has whole numbers of 2^53 or more");
  }
  std::vector<std::uint32_t> entries;
  if (property.shared) entries = detail::entries_of(attribute, mesh.n_faces());
  const auto there = [&] {
    return detail::find_property(mesh, property.element, name, *property.access);
  };
  if (there() == nullptr) {
    detail::add_empty_property(mesh, property.element, name, property.type, property.columns);
  }
  OpenMesh::BaseProperty& to = *there();
  const std::vector<double> none(property.columns, std::numeric_limits<double>::quiet_NaN());
  std::size_t k = 0;
  detail::for_rows(mesh, MeshNumbers(mesh), property.element, [&](std::size_t element) {
    const std::size_t row = property.shared ? entries[k] : k;
    ++k;
    const double* from = row == TALWEG_NO_ENTRY ? none.data() : &values[row * property.columns];
    property.access->put(to, element, from, property.columns);
  });
  return property;
}

}  // namespace talweg::openmesh
