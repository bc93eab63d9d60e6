// Drawings from OpenMesh: paths of handles, marked edges, and labels in properties, in the ids of
// the opened mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/drawing/joined_lines.hpp"
#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace detail {

inline VertexId drawn_vertex(const OpenMeshIds& ids, OpenMesh::VertexHandle v, std::size_t place) {
  const VertexId id = ids.find(v);
  if (id.valid()) return id;
  throw Error(ErrorCode::kBadCurve,
              "Point " + std::to_string(place) + " of the curve is the vertex handle " +
                  std::to_string(v.idx()) + ", which the opened mesh does not have.");
}

}  // namespace detail

/// A curve through vertices, each a neighbour of the next, as input of snap() and draw_edge_path().
/// The curve is closed if `closed` is set or the last handle repeats the first. Smart handles are
/// accepted. Throws Error(kBadCurve) for a handle that is invalid, deleted or not in the opened
/// mesh.
inline CurveInput curve_of(const OpenMeshIds& ids, std::span<const OpenMesh::VertexHandle> vertices,
                           bool closed = false) {
  CurveInput curve;
  curve.closed = closed;
  std::vector<VertexId> points;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    points.push_back(detail::drawn_vertex(ids, vertices[k], k));
  }
  if (points.size() > 3 && points.front() == points.back()) {
    points.pop_back();
    curve.closed = true;
  }
  curve.points = std::move(points);
  return curve;
}

/// A curve along halfedges, each beginning where the previous halfedge ends. The curve is closed if
/// the last halfedge ends where the first begins. Throws Error(kBadCurve) if the halfedges are not
/// consecutive, and as curve_of() for vertices does.
template <OpenMeshKernel Mesh>
CurveInput curve_of(const Mesh& mesh, const OpenMeshIds& ids,
                    std::span<const OpenMesh::HalfedgeHandle> halfedges) {
  std::vector<OpenMesh::VertexHandle> vertices;
  for (std::size_t k = 0; k < halfedges.size(); ++k) {
    const OpenMesh::HalfedgeHandle h = halfedges[k];
    if (!mesh.is_valid_handle(h)) {
      throw Error(ErrorCode::kBadCurve, "The mesh has no halfedge handle " +
                                            std::to_string(h.idx()) + ", which is number " +
                                            std::to_string(k) + " of the curve.");
    }
    if (k > 0 && mesh.from_vertex_handle(h) != vertices.back()) {
      throw Error(ErrorCode::kBadCurve, "Halfedge " + std::to_string(k) +
                                            " of the curve does not begin where the one before "
                                            "ends.");
    }
    if (k == 0) vertices.push_back(mesh.from_vertex_handle(h));
    vertices.push_back(mesh.to_vertex_handle(h));
  }
  return curve_of(ids, vertices);
}

/// Joins edges to curves: loops, and chains that end at vertices with one of the edges or more than
/// two. A curve has the direction of the first halfedge of its first edge. Throws Error(kBadCurve)
/// for edges that the opened mesh does not have.
template <OpenMeshKernel Mesh>
std::vector<CurveInput> curves_of(const Mesh& mesh, const OpenMeshIds& ids,
                                  std::span<const OpenMesh::EdgeHandle> edges) {
  std::vector<Line> lines;
  for (const OpenMesh::EdgeHandle e : edges) {
    if (!mesh.is_valid_handle(e)) {
      throw Error(ErrorCode::kBadCurve,
                  "The mesh has no edge handle " + std::to_string(e.idx()) + ".");
    }
    const OpenMesh::HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    lines.push_back({static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx()),
                     static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx())});
  }
  std::vector<CurveInput> curves;
  for (const Line& line : joined(std::move(lines))) {
    std::vector<OpenMesh::VertexHandle> vertices;
    for (const std::uint32_t v : line) vertices.emplace_back(static_cast<int>(v));
    curves.push_back(curve_of(ids, vertices));
  }
  return curves;
}

/// The edges that are not deleted and fulfil a condition on their handle. O(edges).
template <OpenMeshKernel Mesh, class Condition>
std::vector<OpenMesh::EdgeHandle> edges_where(const Mesh& mesh, const Condition& condition) {
  std::vector<OpenMesh::EdgeHandle> edges;
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {  // skips deleted edges
    if (condition(e)) edges.push_back(e);
  }
  return edges;
}
/// The edges with the status bit `selected`; none if the mesh has no edge status.
template <OpenMeshKernel Mesh>
std::vector<OpenMesh::EdgeHandle> selected_edges(const Mesh& mesh) {
  if (!mesh.has_edge_status()) return {};
  return edges_where(mesh, [&](OpenMesh::EdgeHandle e) { return mesh.status(e).selected(); });
}
template <OpenMeshKernel Mesh>
std::vector<OpenMesh::EdgeHandle> feature_edges(const Mesh& mesh) {
  if (!mesh.has_edge_status()) return {};
  return edges_where(mesh, [&](OpenMesh::EdgeHandle e) { return mesh.status(e).feature(); });
}

/// One label per triangle of the opened mesh, from a property: an FProp, or any type that can be
/// indexed with a FaceHandle. The triangles of a polygon have its label.
template <class Property>
std::vector<std::int64_t> labels_of(const OpenMeshIds& ids, const Property& property) {
  std::vector<std::int64_t> labels;
  for (std::size_t f = 0; f < ids.triangle_count(); ++f) {
    labels.push_back(static_cast<std::int64_t>(property[ids.handle(FaceId{f})]));
  }
  return labels;
}

}  // namespace talweg
