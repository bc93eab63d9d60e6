// For plugins and hosts with OpenMesh: the numbers of a mesh's handles in the interface, a mesh as
// arrays of the interface, and a mesh from such arrays. Programs include talweg_plugin_openmesh.hpp
// or talweg_host_openmesh.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg_arrays.hpp"
#include "talweg_openmesh_faces.hpp"
#include "talweg_plugin.h"

namespace talweg::openmesh {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Numbers from 0 for the elements that are not deleted, in the order of their handles. A mesh
/// without deleted elements needs no memory for them.
template <class Handle>
class Numbers {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  Numbers() = default;
  /// `deleted` returns whether the element of a handle is deleted.
  template <class Deleted>
  Numbers(std::size_t count, const Deleted& deleted) : count_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      const bool gone = deleted(Handle(static_cast<int>(i)));
      if (gone && numbers_.empty()) begin_list(i);
      if (numbers_.empty() && !gone) continue;
      numbers_.push_back(gone ? kNone : static_cast<std::uint32_t>(handles_.size()));
      if (!gone) handles_.push_back(static_cast<int>(i));
    }
  }

  [[nodiscard]] std::size_t size() const { return numbers_.empty() ? count_ : handles_.size(); }
  /// Whether every handle's number is its index.
  [[nodiscard]] bool all() const { return numbers_.empty(); }
  [[nodiscard]] Handle handle(std::size_t number) const {
    return Handle(numbers_.empty() ? static_cast<int>(number) : handles_[number]);
  }
  /// kNone for a deleted element and for a handle that the mesh does not have.
  [[nodiscard]] std::uint32_t number(Handle handle) const {
    if (handle.idx() < 0 || static_cast<std::size_t>(handle.idx()) >= count_) return kNone;
    const auto index = static_cast<std::size_t>(handle.idx());
    return numbers_.empty() ? static_cast<std::uint32_t>(index) : numbers_[index];
  }

 private:
  /// Numbers the elements before the first deleted one.
  void begin_list(std::size_t before) {
    numbers_.reserve(count_);
    for (std::size_t i = 0; i < before; ++i) {
      numbers_.push_back(static_cast<std::uint32_t>(i));
      handles_.push_back(static_cast<int>(i));
    }
  }

  std::size_t count_ = 0;
  std::vector<std::uint32_t> numbers_;
  std::vector<int> handles_;
};

/// The numbers of a mesh's vertices and faces in the interface.
struct MeshNumbers {
  Numbers<VertexHandle> vertices;
  Numbers<FaceHandle> faces;

  MeshNumbers() = default;
  template <class Mesh>
  explicit MeshNumbers(const Mesh& mesh)
      : vertices(
            mesh.n_vertices(),
            [&](VertexHandle v) { return mesh.has_vertex_status() && mesh.status(v).deleted(); }),
        faces(mesh.n_faces(),
              [&](FaceHandle f) { return mesh.has_face_status() && mesh.status(f).deleted(); }) {}
};

/// The halfedges of a face, in the order of its corners; each points to its corner. A newly added
/// face has its corners in the order of its vertex list.
template <class Mesh>
std::array<HalfedgeHandle, 3> corner_halfedges(const Mesh& mesh, FaceHandle f) {
  const HalfedgeHandle h = mesh.halfedge_handle(f);
  const HalfedgeHandle next = mesh.next_halfedge_handle(h);
  return {h, next, mesh.next_halfedge_handle(next)};
}

/// The corners of a face, in the order of barycentric coordinates.
template <class Mesh>
std::array<VertexHandle, 3> corners_of(const Mesh& mesh, FaceHandle f) {
  std::array<VertexHandle, 3> corners;
  const auto halfedges = corner_halfedges(mesh, f);
  for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.to_vertex_handle(halfedges[k]);
  return corners;
}

template <class Mesh>
using ScalarOf = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;

/// A mesh as arrays of the interface, without its deleted elements. Points are not copied if they
/// are contiguous and none is deleted; so the mesh must outlive the arrays, unchanged. Throws
/// plugin::Failure(TALWEG_BAD_MESH) if a face that is not deleted has a deleted vertex.
template <class Mesh>
class MeshArrays {
 public:
  explicit MeshArrays(const Mesh& mesh) : MeshArrays(mesh, MeshNumbers(mesh)) {}
  MeshArrays(const Mesh& mesh, const MeshNumbers& numbers)
      : positions_(positions_of(mesh, numbers.vertices)) {
    triangles_.reserve(3 * numbers.faces.size());
    for (std::size_t k = 0; k < numbers.faces.size(); ++k) {
      const FaceHandle f = numbers.faces.handle(k);
      for (const VertexHandle v : corners_of(mesh, f)) {
        triangles_.push_back(numbers.vertices.number(v));
        if (triangles_.back() != Numbers<VertexHandle>::kNone) continue;
        throw plugin::Failure(TALWEG_BAD_MESH,
                              "Face " + std::to_string(f.idx()) + " has a deleted vertex.");
      }
    }
  }
  MeshArrays(const MeshArrays&) = delete;
  MeshArrays& operator=(const MeshArrays&) = delete;

  [[nodiscard]] talweg_array positions() const { return positions_; }
  [[nodiscard]] talweg_array triangles() const {
    return plugin::view(triangles_.data(), triangles_.size() / 3, 3);
  }

 private:
  using Scalar = ScalarOf<Mesh>;
  static constexpr bool kReal = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;

  talweg_array positions_of(const Mesh& mesh, const Numbers<VertexHandle>& numbers) {
    if (numbers.size() == 0) return plugin::kNoArray;
    if constexpr (kReal) {
      const Scalar* first = &mesh.point(VertexHandle(0))[0];
      if (numbers.all() && &mesh.point(VertexHandle(0))[2] == first + 2) {
        return {first, numbers.size(), sizeof(typename Mesh::Point), 3,
                std::is_same_v<Scalar, double> ? TALWEG_FLOAT64 : TALWEG_FLOAT32};
      }
    }
    copies_.reserve(3 * numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const auto& p = mesh.point(numbers.handle(k));
      for (int i = 0; i < 3; ++i) copies_.push_back(static_cast<double>(p[i]));
    }
    return plugin::view(copies_.data(), numbers.size(), 3);
  }

  std::vector<double> copies_;
  talweg_array positions_;
  std::vector<std::uint32_t> triangles_;
};

/// Fills an empty mesh from arrays: vertex and face k get the handles k, and corners keep their
/// order. Throws plugin::Failure(TALWEG_BAD_MESH), which names a face, for faces that OpenMesh
/// cannot represent together, and for coordinates that are not finite in the mesh's scalar type.
template <class Mesh>
void fill_mesh(Mesh& mesh, const talweg_array& positions, const talweg_array& triangles) {
  const std::vector<double> xyz = plugin::numbers_of(positions, 3, "The mesh's positions");
  const std::vector<std::uint32_t> corners =
      plugin::indices_of(triangles, 3, "The mesh's triangles");
  check_faces(corners, xyz.size() / 3);
  mesh.reserve(xyz.size() / 3, corners.size() / 2, corners.size() / 3);
  for (std::size_t k = 0; k < xyz.size(); k += 3) {
    typename Mesh::Point p;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(std::abs(xyz[k + i]) <=
            static_cast<double>(std::numeric_limits<ScalarOf<Mesh>>::max()))) {
        throw plugin::Failure(
            TALWEG_BAD_MESH,
            "Vertex " + std::to_string(k / 3) + " has a coordinate that is not a finite number.");
      }
      p[i] = static_cast<ScalarOf<Mesh>>(xyz[k + i]);
    }
    mesh.add_vertex(p);
  }
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    const auto at = [&](std::size_t i) { return VertexHandle(static_cast<int>(corners[k + i])); };
    if (mesh.add_face(at(0), at(1), at(2)).is_valid()) continue;
    throw plugin::Failure(TALWEG_BAD_MESH, "OpenMesh cannot add face " + std::to_string(k / 3) +
                                               " to the faces before it.");
  }
}

}  // namespace talweg::openmesh
