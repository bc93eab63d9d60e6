// The sectors of a vertex are its faces between the seams that run through it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <OpenMesh/Core/Mesh/Handles.hh>

namespace talweg {

/// Consecutive faces around a vertex, counterclockwise.
struct VertexSector {
  std::vector<OpenMesh::HalfedgeHandle> outgoing;  ///< from the vertex, one per face

  /// The halfedges on the two sides of the sector: first() leaves the vertex, last() ends there.
  [[nodiscard]] OpenMesh::HalfedgeHandle first() const { return outgoing.front(); }
  template <class Mesh>
  [[nodiscard]] OpenMesh::HalfedgeHandle last(const Mesh& mesh) const {
    return mesh.prev_halfedge_handle(outgoing.back());
  }
  template <class Mesh>
  [[nodiscard]] OpenMesh::FaceHandle least_face(const Mesh& mesh) const {
    OpenMesh::FaceHandle least = mesh.face_handle(first());
    for (const auto h : outgoing) least = std::min(least, mesh.face_handle(h));
    return least;
  }
};

/// The sectors of a vertex, ordered by their smallest face handle. `is_seam` tells whether an edge
/// is a seam. O(degree · log(sectors)).
template <class Mesh, class IsSeam>
std::vector<VertexSector> sectors_of(const Mesh& mesh, OpenMesh::VertexHandle v,
                                     const IsSeam& is_seam) {
  std::vector<OpenMesh::HalfedgeHandle> around;
  const auto begin = mesh.halfedge_handle(v);
  for (auto h = begin; around.empty() || h != begin;
       h = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h))) {
    around.push_back(h);
  }
  const auto starts = [&](std::size_t i) {
    const std::size_t before = (i + around.size() - 1) % around.size();
    return is_seam(mesh.edge_handle(around[i])) || mesh.is_boundary(around[before]);
  };
  std::size_t start = 0;
  while (start < around.size() && !starts(start)) ++start;
  std::vector<VertexSector> sectors;
  for (std::size_t k = 0; k < around.size(); ++k) {
    const std::size_t i = (start + k) % around.size();
    if (mesh.is_boundary(around[i])) continue;
    if (k == 0 || starts(i)) sectors.emplace_back();
    sectors.back().outgoing.push_back(around[i]);
  }
  const auto least = [&](const VertexSector& a, const VertexSector& b) {
    return a.least_face(mesh) < b.least_face(mesh);
  };
  std::sort(sectors.begin(), sectors.end(), least);
  return sectors;
}

}  // namespace talweg
