// The values of OpenMesh properties as rows of numbers, and access to properties whose type is
// known only at run time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/BaseKernel.hh>

#include "talweg_meshes.h"
#include "talweg_plugin.h"

namespace talweg::openmesh::detail {

/// The interface's constant for a type of numbers.
template <class Number>
constexpr std::uint32_t type_of() {
  if constexpr (std::is_same_v<Number, double>) return TALWEG_FLOAT64;
  if constexpr (std::is_same_v<Number, float>) return TALWEG_FLOAT32;
  constexpr bool is_signed = std::is_signed_v<Number>;
  switch (sizeof(Number)) {
    case 1:
      return is_signed ? TALWEG_INT8 : TALWEG_UINT8;
    case 2:
      return is_signed ? TALWEG_INT16 : TALWEG_UINT16;
    case 4:
      return is_signed ? TALWEG_INT32 : TALWEG_UINT32;
    default:
      return is_signed ? TALWEG_INT64 : TALWEG_UINT64;
  }
}

/// A property's value as a row of numbers: a number, a vector of OpenMesh, or a list.
template <class Value>
struct Row {
  using Number = Value;
  static std::uint32_t columns(const Value&) { return 1; }
  static double get(const Value& value, std::uint32_t) { return static_cast<double>(value); }
  static Value made(const double* row, std::uint32_t) { return static_cast<Value>(*row); }
};
template <class N, int n>
struct Row<OpenMesh::VectorT<N, n>> {
  using Number = N;
  using Value = OpenMesh::VectorT<N, n>;
  static std::uint32_t columns(const Value&) { return n; }
  static double get(const Value& value, std::uint32_t k) { return static_cast<double>(value[k]); }
  static Value made(const double* row, std::uint32_t) {
    Value value;
    for (int k = 0; k < n; ++k) value[k] = static_cast<N>(row[k]);
    return value;
  }
};
template <class N>
struct Row<std::vector<N>> {
  using Number = N;
  using Value = std::vector<N>;
  static std::uint32_t columns(const Value& value) {
    return static_cast<std::uint32_t>(value.size());
  }
  static double get(const Value& value, std::uint32_t k) { return static_cast<double>(value[k]); }
  static Value made(const double* row, std::uint32_t columns) {
    Value value(columns);
    for (std::uint32_t k = 0; k < columns; ++k) value[k] = static_cast<N>(row[k]);
    return value;
  }
};

/// Reads and writes the values of properties of one type.
struct Access {
  std::uint32_t type;  ///< type of the numbers
  std::string (*type_name)();
  std::uint32_t (*columns)(const OpenMesh::BaseProperty& property, std::size_t element);
  /// Reads at most `columns` numbers; a list may have fewer.
  void (*get)(const OpenMesh::BaseProperty& property, std::size_t element, double* row,
              std::uint32_t columns);
  void (*put)(OpenMesh::BaseProperty& property, std::size_t element, const double* row,
              std::uint32_t columns);
};

template <class Value>
struct AccessTo {
  using Property = OpenMesh::PropertyT<Value>;

  static std::uint32_t columns(const OpenMesh::BaseProperty& property, std::size_t element) {
    return Row<Value>::columns(static_cast<const Property&>(property).data_vector()[element]);
  }
  static void get(const OpenMesh::BaseProperty& property, std::size_t element, double* row,
                  std::uint32_t columns) {
    const Value& value = static_cast<const Property&>(property).data_vector()[element];
    const std::uint32_t count = std::min(columns, Row<Value>::columns(value));
    for (std::uint32_t k = 0; k < count; ++k) row[k] = Row<Value>::get(value, k);
  }
  static void put(OpenMesh::BaseProperty& property, std::size_t element, const double* row,
                  std::uint32_t columns) {
    static_cast<Property&>(property).data_vector()[element] = Row<Value>::made(row, columns);
  }
  static constexpr Access kAll = {type_of<typename Row<Value>::Number>(),
                                  OpenMesh::get_type_name<Value>, columns, get, put};
};

/// Calls `use` with a null pointer to the type for values of this many columns: a number, VectorT
/// of 2 to 4, or else std::vector.
template <class Number, class Use>
auto with_columns(std::uint32_t columns, const Use& use) {
  switch (columns) {
    case 1:
      return use(static_cast<Number*>(nullptr));
    case 2:
      return use(static_cast<OpenMesh::VectorT<Number, 2>*>(nullptr));
    case 3:
      return use(static_cast<OpenMesh::VectorT<Number, 3>*>(nullptr));
    case 4:
      return use(static_cast<OpenMesh::VectorT<Number, 4>*>(nullptr));
    default:
      return use(static_cast<std::vector<Number>*>(nullptr));
  }
}

/// Calls `use` as with_columns() does, for a type of numbers of the interface, which must be known.
template <class Use>
auto with_type(std::uint32_t type, std::uint32_t columns, const Use& use) {
  switch (type) {
    case TALWEG_FLOAT32:
      return with_columns<float>(columns, use);
    case TALWEG_INT8:
      return with_columns<std::int8_t>(columns, use);
    case TALWEG_UINT8:
      return with_columns<std::uint8_t>(columns, use);
    case TALWEG_INT16:
      return with_columns<std::int16_t>(columns, use);
    case TALWEG_UINT16:
      return with_columns<std::uint16_t>(columns, use);
    case TALWEG_INT32:
      return with_columns<std::int32_t>(columns, use);
    case TALWEG_UINT32:
      return with_columns<std::uint32_t>(columns, use);
    case TALWEG_INT64:
      return with_columns<std::int64_t>(columns, use);
    case TALWEG_UINT64:
      return with_columns<std::uint64_t>(columns, use);
    default:
      return with_columns<double>(columns, use);
  }
}

inline const Access& access(std::uint32_t type, std::uint32_t columns) {
  return *with_type(type, columns, []<class Value>(Value*) { return &AccessTo<Value>::kAll; });
}

/// The access to an existing property; null if its values are not rows of numbers.
inline const Access* access_to(const OpenMesh::BaseProperty& property) {
  for (std::uint32_t type = TALWEG_FLOAT64; type <= TALWEG_UINT16; ++type) {
    for (const std::uint32_t columns : {1, 2, 3, 4, 5}) {
      const Access& one = access(type, columns);
      if (one.type_name() == property.internal_type_name()) return &one;
    }
  }
  const Access& flags = AccessTo<bool>::kAll;
  return flags.type_name() == property.internal_type_name() ? &flags : nullptr;
}

/// The properties of a mesh for attributes of this element; attributes of corners are properties of
/// halfedges.
template <class Mesh>
auto properties_at(const Mesh& mesh, std::uint32_t element) {
  if (element == TALWEG_OF_VERTICES) return std::pair(mesh.vprops_begin(), mesh.vprops_end());
  if (element == TALWEG_OF_TRIANGLES) return std::pair(mesh.fprops_begin(), mesh.fprops_end());
  return std::pair(mesh.hprops_begin(), mesh.hprops_end());
}

/// The first property with this name and type; null if there is none.
template <class Mesh>
OpenMesh::BaseProperty* find_property(const Mesh& mesh, std::uint32_t element,
                                      const std::string& name, const Access& access) {
  const auto [begin, end] = properties_at(mesh, element);
  for (auto at = begin; at != end; ++at) {
    if (*at == nullptr || (*at)->name() != name) continue;
    if ((*at)->internal_type_name() == access.type_name()) return *at;
  }
  return nullptr;
}

template <class Mesh>
void add_empty_property(Mesh& mesh, std::uint32_t element, const std::string& name,
                        std::uint32_t type, std::uint32_t columns) {
  with_type(type, columns, [&]<class Value>(Value*) {
    if (element == TALWEG_OF_VERTICES) {
      OpenMesh::VPropHandleT<Value> handle;
      mesh.add_property(handle, name);
    } else if (element == TALWEG_OF_TRIANGLES) {
      OpenMesh::FPropHandleT<Value> handle;
      mesh.add_property(handle, name);
    } else {
      OpenMesh::HPropHandleT<Value> handle;
      mesh.add_property(handle, name);
    }
  });
}

}  // namespace talweg::openmesh::detail
