// Curve points convert to OpenMesh handles, and back.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A point inside an edge: (1 - t) · tail + t · head of the halfedge; 0 < t < 1.
struct OnHalfedge {
  OpenMesh::HalfedgeHandle halfedge;
  double t = 0.5;
};

/// A point inside a face, as a weighted mean of three corners. A corner is named by the face's
/// halfedge that ends there, so attributes of halfedges can be interpolated, too. In a polygon the
/// corners are those of a triangle of its fan, and one weight may be 0.
struct InFaceHandle {
  OpenMesh::FaceHandle face;
  std::array<OpenMesh::HalfedgeHandle, 3> corners;
  std::array<double, 3> barycentric{};  ///< >= 0, with the sum 1
};

using HandlePoint = std::variant<OpenMesh::VertexHandle, OnHalfedge, InFaceHandle>;

namespace detail {

template <OpenMeshKernel Mesh>
HandlePoint in_face(const Mesh& mesh, const OpenMeshIds& ids, const FaceCoordinates& at) {
  InFaceHandle result;
  result.face = ids.handle(at.face);
  result.barycentric = at.barycentric;
  const auto corners = corner_halfedges(mesh, result.face);
  const std::array<std::size_t, 3> of_triangle = ids.corners(at.face);
  for (std::size_t k = 0; k < 3; ++k) result.corners[k] = corners.at(of_triangle[k]);
  return result;
}

}  // namespace detail

/// Converts a point of the opened mesh. `ids` and `surface` come from opening `mesh`, which must be
/// unchanged. O(degree).
template <OpenMeshKernel Mesh>
HandlePoint handle_point(const Mesh& mesh, const OpenMeshIds& ids, const Surface& surface,
                         const SurfacePoint& point) {
  if (const auto* at = std::get_if<AtVertex>(&point.where())) return ids.handle(at->vertex);
  if (const auto* at = std::get_if<InFace>(&point.where())) {
    return detail::in_face(mesh, ids, {at->face, at->barycentric});
  }
  const auto& at = std::get<OnEdge>(point.where());
  const HalfedgeId h = halfedge_of(at.edge);
  const OpenMesh::HalfedgeHandle halfedge =
      mesh.find_halfedge(ids.handle(surface.tail(h)), ids.handle(surface.head(h)));
  if (halfedge.is_valid()) return OnHalfedge{halfedge, at.t};
  // The edge is a diagonal of a polygon.
  return detail::in_face(mesh, ids, coordinates_in(surface, point, any_face(surface, point)));
}

template <OpenMeshKernel Mesh>
std::vector<HandlePoint> handle_points(const Mesh& mesh, const OpenMeshIds& ids,
                                       const Surface& surface, const SurfaceCurve& curve) {
  std::vector<HandlePoint> points;
  points.reserve(curve.points.size());
  for (const SurfacePoint& point : curve.points) {
    points.push_back(handle_point(mesh, ids, surface, point));
  }
  return points;
}

/// Converts handles to a point of the opened mesh. Throws Error(kBadCurve) for a handle that is
/// invalid, deleted or not in the opened mesh, and for `t` or barycentric coordinates out of range.
template <OpenMeshKernel Mesh>
SurfacePoint surface_point(const Mesh& mesh, const OpenMeshIds& ids, const Surface& surface,
                           const HandlePoint& point) {
  const auto refuse = [](const std::string& what, int handle) -> Error {
    return Error(ErrorCode::kBadCurve,
                 "The " + what + " handle " + std::to_string(handle) +
                     " of a point does not belong to the mesh that was opened.");
  };
  const auto vertex = [&](OpenMesh::VertexHandle v) {
    const VertexId id = ids.find(v);
    if (!id.valid()) throw refuse("vertex", v.idx());
    return id;
  };
  if (const auto* v = std::get_if<OpenMesh::VertexHandle>(&point)) {
    return SurfacePoint::at_vertex(surface, vertex(*v));
  }
  if (const auto* on = std::get_if<OnHalfedge>(&point)) {
    const OpenMesh::HalfedgeHandle h = on->halfedge;
    if (!mesh.is_valid_handle(h)) throw refuse("halfedge", h.idx());
    const HalfedgeId id =
        surface.find_halfedge(vertex(mesh.from_vertex_handle(h)), vertex(mesh.to_vertex_handle(h)));
    if (!id.valid()) throw refuse("halfedge", h.idx());
    const bool along = id == halfedge_of(edge_of(id));
    return SurfacePoint::on_edge(surface, edge_of(id), along ? on->t : 1 - on->t);
  }
  const auto& in = std::get<InFaceHandle>(point);
  const FaceId first = mesh.is_valid_handle(in.face) ? ids.id(in.face) : FaceId();
  if (!first.valid()) throw refuse("face", in.face.idx());
  for (std::size_t f = first.index(); f < ids.triangle_count(); ++f) {
    if (ids.handle(FaceId{f}) != in.face) break;
    const std::array<VertexId, 3> corners = surface.corners(FaceId{f});
    std::array<double, 3> barycentric{};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!mesh.is_valid_handle(in.corners[k])) throw refuse("halfedge", in.corners[k].idx());
      const VertexId v = vertex(mesh.to_vertex_handle(in.corners[k]));
      for (std::size_t c = 0; c < 3; ++c) {
        if (corners[c] != v) continue;
        barycentric[c] = in.barycentric[k];
        ++found;
      }
    }
    if (found == 3) return SurfacePoint::from_barycentric(surface, FaceId{f}, barycentric);
  }
  throw refuse("face", in.face.idx());
}

}  // namespace talweg
