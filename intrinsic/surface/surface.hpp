// A surface is intrinsic: it has triangle connectivity and one length per edge, but no positions.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// Three vertex indices of a triangle, counterclockwise.
using Triangle = std::array<std::uint32_t, 3>;

/// An oriented triangulated 2-manifold, with or without boundary, of any genus and with any number
/// of components; isolated vertices are allowed. Immutable.
///
/// Halfedges 2e and 2e + 1 are twins. A halfedge on the boundary has no face and no next.
/// The three halfedges of face f start at halfedge(f), whose tail is the first corner of the face
/// as it was given.
class Surface {
 public:
  Surface() = default;

  /// Builds the connectivity of a simplicial surface; all lengths are 0 until set. O(faces).
  /// Throws Error(kBadMesh) naming the first offender when an index is out of range, a face
  /// repeats a vertex, an edge has more than two faces or two faces of equal direction, or the
  /// faces around a vertex form more than one fan.
  static Surface from_triangles(std::size_t vertex_count, std::span<const Triangle> triangles);

  /// Builds a Δ-complex: corner k of face f is `triangles[f][k]`; side k runs from corner k to
  /// corner k + 1 and is glued to the side `gluing[3 f + k]` (numbered 3 f' + k'), or is on the
  /// boundary (kNoSide). Multi-edges, self-edges and faces glued to themselves are allowed.
  /// Throws Error(kBadMesh) when the gluing is not an involution, joins different vertices, or
  /// glues a side to itself.
  static constexpr std::uint32_t kNoSide = 0xFFFFFFFFU;
  static Surface from_gluing(std::size_t vertex_count, std::span<const Triangle> triangles,
                             std::span<const std::uint32_t> gluing);

  /// Sets one length per edge, finite and >= 0. Throws Error(kBadMesh) when the number of lengths
  /// is not edge_count(), or naming the first edge whose length is negative or not finite.
  void set_lengths(std::vector<double> lengths);

  [[nodiscard]] std::size_t vertex_count() const { return vertex_halfedge_.size(); }
  [[nodiscard]] std::size_t edge_count() const { return halfedges_.size() / 2; }
  [[nodiscard]] std::size_t halfedge_count() const { return halfedges_.size(); }
  [[nodiscard]] std::size_t face_count() const { return face_halfedge_.size(); }

  /// Invalid on the boundary.
  [[nodiscard]] HalfedgeId next(HalfedgeId h) const { return halfedges_[h.index()].next; }
  [[nodiscard]] HalfedgeId prev(HalfedgeId h) const { return next(next(h)); }
  [[nodiscard]] FaceId face(HalfedgeId h) const { return halfedges_[h.index()].face; }
  [[nodiscard]] VertexId tail(HalfedgeId h) const { return halfedges_[h.index()].tail; }
  [[nodiscard]] VertexId head(HalfedgeId h) const { return tail(twin(h)); }
  [[nodiscard]] bool has_face(HalfedgeId h) const { return next(h).valid(); }
  [[nodiscard]] bool on_boundary(EdgeId e) const {
    return !has_face(halfedge_of(e)) || !has_face(twin(halfedge_of(e)));
  }
  [[nodiscard]] bool on_boundary(VertexId v) const {
    return vertex_halfedge_[v.index()].valid() && !has_face(twin(vertex_halfedge_[v.index()]));
  }
  [[nodiscard]] HalfedgeId halfedge(FaceId f) const { return face_halfedge_[f.index()]; }
  /// An outgoing halfedge with a face; at a boundary vertex the most clockwise one, so that
  /// turning counterclockwise from it meets every face. Invalid at an isolated vertex.
  [[nodiscard]] HalfedgeId halfedge(VertexId v) const { return vertex_halfedge_[v.index()]; }

  /// The next outgoing halfedge counterclockwise about the tail of h (h must have a face). The
  /// result has no face where the boundary is reached.
  [[nodiscard]] HalfedgeId turn_ccw(HalfedgeId h) const { return twin(prev(h)); }
  /// The next outgoing halfedge clockwise about the tail of h; invalid at the boundary.
  [[nodiscard]] HalfedgeId turn_cw(HalfedgeId h) const { return next(twin(h)); }

  [[nodiscard]] std::array<VertexId, 3> corners(FaceId f) const;
  [[nodiscard]] double length(EdgeId e) const { return lengths_[e.index()]; }
  [[nodiscard]] std::span<const double> lengths() const { return lengths_; }
  /// A halfedge from a to b; invalid if there is none. O(degree of a).
  [[nodiscard]] HalfedgeId find_halfedge(VertexId a, VertexId b) const;

  struct Halfedge {
    HalfedgeId next;
    VertexId tail;
    FaceId face;
  };
  [[nodiscard]] std::span<const Halfedge> halfedges() const { return halfedges_; }
  [[nodiscard]] std::span<const HalfedgeId> vertex_halfedges() const { return vertex_halfedge_; }

 private:
  void glue(std::size_t vertex_count, std::span<const Triangle> triangles,
            std::span<const std::uint32_t> gluing);

  std::vector<Halfedge> halfedges_;
  std::vector<HalfedgeId> vertex_halfedge_;
  std::vector<HalfedgeId> face_halfedge_;
  std::vector<double> lengths_;
};

/// The connected component of every vertex (isolated vertices are components of their own),
/// numbered by smallest vertex. O(vertices + edges).
struct Components {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_vertex;
};
Components components_of(const Surface& surface);

}  // namespace talweg
