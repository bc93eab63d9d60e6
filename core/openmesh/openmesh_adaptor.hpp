// The OpenMesh adaptor makes our types from OpenMesh's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// Which handle became which id. They differ where elements are deleted but not yet collected.
class OpenMeshIds {
 public:
  /// Invalid for a deleted element.
  [[nodiscard]] VertexId id(OpenMesh::VertexHandle v) const {
    return VertexId{vertex_ids_.at(static_cast<std::size_t>(v.idx()))};
  }
  [[nodiscard]] FaceId id(OpenMesh::FaceHandle f) const {
    return FaceId{face_ids_.at(static_cast<std::size_t>(f.idx()))};
  }
  [[nodiscard]] OpenMesh::VertexHandle handle(VertexId v) const {
    return OpenMesh::VertexHandle(vertex_handles_.at(v.index()));
  }
  [[nodiscard]] OpenMesh::FaceHandle handle(FaceId f) const {
    return OpenMesh::FaceHandle(face_handles_.at(f.index()));
  }

  void add_vertex(bool deleted) { add(vertex_ids_, vertex_handles_, deleted); }
  void add_face(bool deleted) { add(face_ids_, face_handles_, deleted); }

 private:
  static void add(std::vector<std::uint32_t>& ids, std::vector<int>& handles, bool deleted) {
    ids.push_back(deleted ? VertexId::kInvalid : static_cast<std::uint32_t>(handles.size()));
    if (!deleted) handles.push_back(static_cast<int>(ids.size()) - 1);
  }

  std::vector<std::uint32_t> vertex_ids_;
  std::vector<std::uint32_t> face_ids_;
  std::vector<int> vertex_handles_;
  std::vector<int> face_handles_;
};

/// The mesh's points (converted to double) and triangles, without its deleted elements; `ids`, if
/// given, receives the numbering. Only point(), connectivity and the deleted bits are used, so any
/// traits will do. Corners keep the order in which a face was added. O(mesh).
/// Throws Error(kBadMesh) when a face that is not deleted has a deleted vertex.
template <class Traits>
MeshLists lists_of(const OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh, OpenMeshIds* ids = nullptr) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  MeshLists lists;
  lists.single_precision = std::is_same_v<Scalar, float>;
  lists.points.reserve(mesh.n_vertices());
  lists.triangles.reserve(mesh.n_faces());
  OpenMeshIds numbering;
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
    const OpenMesh::VertexHandle v(static_cast<int>(i));
    const bool deleted = mesh.has_vertex_status() && mesh.status(v).deleted();
    numbering.add_vertex(deleted);
    if (deleted) continue;
    const auto& p = mesh.point(v);
    lists.points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]),
                              static_cast<double>(p[2]));
  }
  for (std::size_t i = 0; i < mesh.n_faces(); ++i) {
    const OpenMesh::FaceHandle f(static_cast<int>(i));
    const bool deleted = mesh.has_face_status() && mesh.status(f).deleted();
    numbering.add_face(deleted);
    if (deleted) continue;
    Triangle triangle{};
    OpenMesh::HalfedgeHandle h = mesh.halfedge_handle(f);
    for (std::uint32_t& corner : triangle) {
      const VertexId v = numbering.id(mesh.to_vertex_handle(h));
      if (!v.valid()) {
        throw Error(ErrorCode::kBadMesh, "Face " + std::to_string(i) + " has a deleted vertex.");
      }
      corner = static_cast<std::uint32_t>(v.index());
      h = mesh.next_halfedge_handle(h);
    }
    lists.triangles.push_back(triangle);
  }
  if (ids != nullptr) *ids = std::move(numbering);
  return lists;
}

/// Opens an OpenMesh mesh: SurfaceMesh::open(lists_of(mesh)), with its errors. Later edits of
/// `mesh` change nothing.
template <class Traits>
SurfaceMesh surface_of(const OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh,
                       OpenMeshIds* ids = nullptr) {
  return SurfaceMesh::open(lists_of(mesh, ids));
}

/// The same, made ready for CurveSmoother.
template <class Traits>
std::shared_ptr<const OpenedMesh> open_mesh(const OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh,
                                            OpenMeshIds* ids = nullptr) {
  return OpenedMesh::open(surface_of(mesh, ids));
}

}  // namespace talweg
