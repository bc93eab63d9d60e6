// Flat flips change the subdivision of a face of the surface, not the surface.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <unordered_set>
#include <vector>

#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

namespace talweg {

/// The barycentrics of a vertex in a face of the surface that contains the vertex.
std::array<double, 3> weights_in(const SignpostTriangulation& triangulation, VertexId v,
                                 FaceId face);

/// The signed area of a triangle relative to the area of the face; corners are barycentrics.
inline double orient(const std::array<double, 3>& a, const std::array<double, 3>& b,
                     const std::array<double, 3>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Flips of edges inside faces of the surface, during the insertion of points. The pieces of a face
/// lie in one plane, so the new length of a flipped edge is exact. Flipped edges stay until
/// SignpostTriangulation::remove_inserted().
///
/// Points that are inserted one by one leave fans of needles, and a segment across k edges of
/// needles would need k more vertices. With Delaunay pieces, whose edges are flipped out of a
/// segment's way, n points need O(n) vertices and pieces.
class FlatFlips {
 public:
  static constexpr double kOnSide = 1e-10;  ///< nearer points lie on a line; relative to a piece

  /// `before` is called with a halfedge before each flip of its edge.
  FlatFlips(SignpostTriangulation& triangulation, std::function<void(HalfedgeId)> before)
      : triangulation_(&triangulation), before_(std::move(before)) {}

  /// Excludes an edge from flips, because a segment runs along it.
  void fix(EdgeId e) { fixed_.insert(e); }
  [[nodiscard]] bool is_fixed(EdgeId e) const { return fixed_.contains(e); }
  /// Whether the edge was inserted and has pieces of one face of the surface on both sides.
  [[nodiscard]] bool is_inside(HalfedgeId h) const;

  /// Flips edges until `edges` and the edges around them are Delaunay, except for fixed edges. A
  /// few flips per edge as a rule.
  void improve(std::vector<HalfedgeId> edges);

  /// The edges that the straight segment to a vertex crosses.
  struct Segment {
    std::vector<HalfedgeId> crossed;  ///< from right to left
    VertexId end;                     ///< the first vertex on the segment, if any
    HalfedgeId stop;                  ///< else the fixed edge where the segment stops
    double part = 0;                  ///< the crossing on `stop`, a fraction of its length
  };
  /// The segment from the tail of h to `to`, which starts in the face of h.
  [[nodiscard]] Segment segment(HalfedgeId h, VertexId to, FaceId face) const;
  /// Flips the crossed edges out of the segment's way, then improves them. Returns the edge between
  /// the two vertices; invalid if rounding prevents it. O(crossed) flips as a rule, at most the
  /// square (Sloan 1993).
  HalfedgeId clear(const Segment& segment, VertexId from, VertexId to, FaceId face);

 private:
  using Weights = std::array<double, 3>;
  [[nodiscard]] bool is_convex(HalfedgeId h) const;
  [[nodiscard]] bool is_delaunay(HalfedgeId h) const;
  void flip(HalfedgeId h);

  SignpostTriangulation* triangulation_;
  std::function<void(HalfedgeId)> before_;
  std::unordered_set<EdgeId> fixed_;  // never iterated
};

}  // namespace talweg
