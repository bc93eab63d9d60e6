// The OpenMesh adaptor converts OpenMesh meshes to the mesh types of the library.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// A TriMesh_ArrayKernelT or PolyMesh_ArrayKernelT of any traits.
template <class Mesh>
concept OpenMeshKernel = std::derived_from<Mesh, OpenMesh::PolyConnectivity> &&
    requires(const Mesh& mesh, OpenMesh::VertexHandle v) {
  mesh.point(v)[0];
};

/// Maps between OpenMesh handles and ids of the opened mesh. Ids differ from handles if elements
/// are deleted but not yet collected, or if polygons became fans of triangles.
class OpenMeshIds {
 public:
  /// Invalid for a deleted element. Throws Error(kBadUsage) for a handle that the opened mesh did
  /// not have.
  [[nodiscard]] VertexId id(OpenMesh::VertexHandle v) const {
    return VertexId{at(vertex_ids_, v.idx(), "vertex")};
  }
  /// The first triangle of the face; the others of its fan follow.
  [[nodiscard]] FaceId id(OpenMesh::FaceHandle f) const {
    return FaceId{at(face_ids_, f.idx(), "face")};
  }
  /// Like id(), but invalid also for a handle that the opened mesh did not have.
  [[nodiscard]] VertexId find(OpenMesh::VertexHandle v) const {
    const bool known = v.idx() >= 0 && static_cast<std::size_t>(v.idx()) < vertex_ids_.size();
    return known ? id(v) : VertexId();
  }
  [[nodiscard]] OpenMesh::VertexHandle handle(VertexId v) const {
    return OpenMesh::VertexHandle(vertex_handles_.at(v.index()));
  }
  [[nodiscard]] OpenMesh::FaceHandle handle(FaceId f) const {
    return OpenMesh::FaceHandle(face_handles_.at(f.index()));
  }
  /// The number of handles at opening, deleted elements included.
  [[nodiscard]] std::size_t vertex_handle_count() const { return vertex_ids_.size(); }
  [[nodiscard]] std::size_t face_handle_count() const { return face_ids_.size(); }
  [[nodiscard]] std::size_t vertex_count() const { return vertex_handles_.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return face_handles_.size(); }
  /// The corners of triangle `f` as positions in the corner list of its polygon: 0, k + 1, k + 2
  /// for triangle k of the fan.
  [[nodiscard]] std::array<std::size_t, 3> corners(FaceId f) const {
    const std::size_t k = f.index() - id(handle(f)).index();
    return {0, k + 1, k + 2};
  }

  friend bool operator==(const OpenMeshIds&, const OpenMeshIds&) = default;

  void add_vertex(bool deleted) {
    vertex_ids_.push_back(deleted ? VertexId::kInvalid : size_of(vertex_handles_));
    if (!deleted) vertex_handles_.push_back(static_cast<int>(vertex_ids_.size()) - 1);
  }
  /// `triangles`: the number of triangles of the face, 0 if it is deleted.
  void add_face(std::size_t triangles) {
    face_ids_.push_back(triangles == 0 ? FaceId::kInvalid : size_of(face_handles_));
    face_handles_.insert(face_handles_.end(), triangles, static_cast<int>(face_ids_.size()) - 1);
  }

 private:
  static std::uint32_t size_of(const std::vector<int>& handles) {
    return static_cast<std::uint32_t>(handles.size());
  }
  static std::uint32_t at(const std::vector<std::uint32_t>& ids, int handle, const char* what) {
    if (handle >= 0 && static_cast<std::size_t>(handle) < ids.size()) {
      return ids[static_cast<std::size_t>(handle)];
    }
    throw Error(ErrorCode::kBadUsage, "The " + std::string(what) + " handle " +
                                          std::to_string(handle) +
                                          " does not belong to the mesh that was opened.");
  }

  std::vector<std::uint32_t> vertex_ids_;
  std::vector<std::uint32_t> face_ids_;
  std::vector<int> vertex_handles_;
  std::vector<int> face_handles_;
};

namespace detail {

template <OpenMeshKernel Mesh>
bool is_deleted(const Mesh& mesh, OpenMesh::VertexHandle v) {
  return mesh.has_vertex_status() && mesh.status(v).deleted();
}
template <OpenMeshKernel Mesh>
bool is_deleted(const Mesh& mesh, OpenMesh::FaceHandle f) {
  return mesh.has_face_status() && mesh.status(f).deleted();
}

/// The halfedges of a face, each ending at a corner, in the order in which add_face() got the
/// corners.
template <OpenMeshKernel Mesh>
std::vector<OpenMesh::HalfedgeHandle> corner_halfedges(const Mesh& mesh, OpenMesh::FaceHandle f) {
  std::vector<OpenMesh::HalfedgeHandle> corners;
  const OpenMesh::HalfedgeHandle first = mesh.halfedge_handle(f);
  OpenMesh::HalfedgeHandle h = first;
  do {
    corners.push_back(h);
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return corners;
}

}  // namespace detail

/// The points (as double) and triangles of the mesh, without deleted elements; `ids`, if given,
/// receives the numbering. triangulate_polygons() divides polygons. The function reads only
/// point(), connectivity and the deleted bits, so it accepts any traits. Corners keep the order of
/// add_face(). O(mesh). Throws Error(kBadMesh) if a face that is not deleted has a deleted vertex.
template <OpenMeshKernel Mesh>
MeshLists lists_of(const Mesh& mesh, OpenMeshIds* ids = nullptr) {
  using Scalar = std::remove_cvref_t<decltype(mesh.point(OpenMesh::VertexHandle())[0])>;
  MeshLists lists;
  lists.single_precision = std::is_same_v<Scalar, float>;
  lists.points.reserve(mesh.n_vertices());
  lists.triangles.reserve(mesh.n_faces());
  OpenMeshIds numbering;
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
    const OpenMesh::VertexHandle v(static_cast<int>(i));
    const bool deleted = detail::is_deleted(mesh, v);
    numbering.add_vertex(deleted);
    if (deleted) continue;
    const auto& p = mesh.point(v);
    lists.points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]),
                              static_cast<double>(p[2]));
  }
  const auto corner = [&](OpenMesh::HalfedgeHandle h, std::size_t face) {
    const VertexId v = numbering.id(mesh.to_vertex_handle(h));
    if (v.valid()) return static_cast<std::uint32_t>(v.index());
    throw Error(ErrorCode::kBadMesh, "Face " + std::to_string(face) + " has a deleted vertex.");
  };
  for (std::size_t i = 0; i < mesh.n_faces(); ++i) {
    const OpenMesh::FaceHandle f(static_cast<int>(i));
    const std::size_t before = lists.triangles.size();
    if (!detail::is_deleted(mesh, f)) {
      const OpenMesh::HalfedgeHandle first = mesh.halfedge_handle(f);
      OpenMesh::HalfedgeHandle h = mesh.next_halfedge_handle(first);
      Triangle triangle{corner(first, i), 0, corner(h, i)};
      for (h = mesh.next_halfedge_handle(h); h != first; h = mesh.next_halfedge_handle(h)) {
        triangle[1] = triangle[2];
        triangle[2] = corner(h, i);
        lists.triangles.push_back(triangle);
      }
      const std::size_t more = lists.triangles.size() - before;
      if (more > 1) {
        ++lists.polygon_count;
        lists.polygons.push_back(
            {static_cast<std::uint32_t>(before), static_cast<std::uint32_t>(more + 2)});
      }
    }
    numbering.add_face(lists.triangles.size() - before);
  }
  triangulate_polygons(lists);
  if (ids != nullptr) *ids = std::move(numbering);
  return lists;
}

/// Opens an OpenMesh mesh: SurfaceMesh::open(lists_of(mesh)), with its errors. The result is a
/// copy: later edits of `mesh` do not affect it.
template <OpenMeshKernel Mesh>
SurfaceMesh surface_of(const Mesh& mesh, OpenMeshIds* ids = nullptr) {
  return SurfaceMesh::open(lists_of(mesh, ids));
}

/// Opens an OpenMesh mesh for CurveSmoother: OpenedMesh::open(surface_of(mesh)), with its errors.
template <OpenMeshKernel Mesh>
std::shared_ptr<const OpenedMesh> open_mesh(const Mesh& mesh, OpenMeshIds* ids = nullptr) {
  return OpenedMesh::open(surface_of(mesh, ids));
}

}  // namespace talweg
