// Values per vertex or triangle of the opened mesh become named OpenMesh properties.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// Persistent properties are written to .om files.
enum class PropertyLife { kTemporary, kPersistent };

namespace detail {

/// Throws Error(kBadUsage) if a property of this name has another type: OpenMesh would add a second
/// property of the same name.
template <class Iterator>
void check_type(bool has_it, Iterator first, Iterator last, const std::string& name) {
  if (has_it) return;
  for (; first != last; ++first) {
    if (*first != nullptr && (*first)->name() == name) {
      throw Error(ErrorCode::kBadUsage,
                  "The mesh has a property \"" + name + "\" already, of another type.");
    }
  }
}

inline void check_count(std::size_t given, std::size_t expected, const char* what) {
  if (given == expected) return;
  throw Error(ErrorCode::kBadUsage, std::to_string(given) + " values were given for " +
                                        std::to_string(expected) + " " + what + ".");
}

/// Makes or fills a property of vertices or faces. `handles`: the number of elements, deleted
/// elements included.
template <class T, class Handle, OpenMeshKernel Mesh, class Value>
auto filled(Mesh& mesh, const OpenMeshIds& ids, std::size_t handles, const std::string& name,
            const std::vector<Value>& values, PropertyLife life) {
  auto property = OpenMesh::getOrMakeProperty<Handle, T>(mesh, name.c_str());
  mesh.property(property.getRawProperty()).set_persistent(life == PropertyLife::kPersistent);
  for (std::size_t k = 0; k < handles; ++k) {
    const Handle handle(static_cast<int>(k));
    const auto id = ids.id(handle);
    property[handle] = id.valid() ? static_cast<T>(values[id.index()]) : T();
  }
  return property;
}

}  // namespace detail

/// Makes or fills a vertex property. `values` has one entry per vertex of the opened mesh; deleted
/// vertices get T(). O(vertices). Throws Error(kBadUsage) for another number of values, or if a
/// property of this name has another type; the mesh is then unchanged.
template <class T, OpenMeshKernel Mesh, class Value>
OpenMesh::VProp<T> vertex_property(Mesh& mesh, const OpenMeshIds& ids, const std::string& name,
                                   const std::vector<Value>& values,
                                   PropertyLife life = PropertyLife::kTemporary) {
  detail::check_count(values.size(), ids.vertex_count(), "vertices");
  detail::check_type(OpenMesh::hasProperty<OpenMesh::VertexHandle, T>(mesh, name.c_str()),
                     mesh.vprops_begin(), mesh.vprops_end(), name);
  return detail::filled<T, OpenMesh::VertexHandle>(mesh, ids, ids.vertex_handle_count(), name,
                                                   values, life);
}

/// Makes or fills a face property, with the errors of vertex_property(). `values` has one entry per
/// triangle of the opened mesh; a polygon gets the value of the first triangle of its fan.
template <class T, OpenMeshKernel Mesh, class Value>
OpenMesh::FProp<T> face_property(Mesh& mesh, const OpenMeshIds& ids, const std::string& name,
                                 const std::vector<Value>& values,
                                 PropertyLife life = PropertyLife::kTemporary) {
  detail::check_count(values.size(), ids.triangle_count(), "triangles");
  detail::check_type(OpenMesh::hasProperty<OpenMesh::FaceHandle, T>(mesh, name.c_str()),
                     mesh.fprops_begin(), mesh.fprops_end(), name);
  return detail::filled<T, OpenMesh::FaceHandle>(mesh, ids, ids.face_handle_count(), name, values,
                                                 life);
}

}  // namespace talweg
