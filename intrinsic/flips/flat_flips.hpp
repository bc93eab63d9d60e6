// Flat flips change how a face of the surface is divided, not the surface.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <unordered_set>
#include <vector>

#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

namespace talweg {

/// Where a vertex lies in a face of the surface, as barycentrics.
std::array<double, 3> weights_in(const SignpostTriangulation& triangulation, VertexId v,
                                 FaceId face);

/// Twice the signed area of a triangle, in units of the face (barycentrics are affine).
inline double orient(const std::array<double, 3>& a, const std::array<double, 3>& b,
                     const std::array<double, 3>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Flips of edges inside faces of the surface, while points are inserted. There the pieces lie in
/// one plane, so an edge can be turned with its exact new length. It stays turned until
/// SignpostTriangulation::remove_inserted().
///
/// Points that are inserted one by one leave fans of needles, and a segment across k of their edges
/// would need k vertices more. With Delaunay pieces, whose edges make way for a segment, n points
/// need about n of each.
class FlatFlips {
 public:
  static constexpr double kOnSide = 1e-10;  ///< points that near to a line are on it, of the extent

  /// `before` is called with a halfedge that is going to turn.
  FlatFlips(SignpostTriangulation& triangulation, std::function<void(HalfedgeId)> before)
      : triangulation_(&triangulation), before_(std::move(before)) {}

  /// Edges of segments stay where they are.
  void fix(EdgeId e) { fixed_.insert(e); }
  [[nodiscard]] bool is_fixed(EdgeId e) const { return fixed_.contains(e); }
  /// Whether a face of the triangulation lies on each side, both in the same face of the surface.
  [[nodiscard]] bool is_inside(HalfedgeId h) const;

  /// Flips edges until these and those beside them are Delaunay, as far as they may. As a rule a
  /// few flips for an edge.
  void improve(std::vector<HalfedgeId> edges);

  /// The edges that the straight way to a vertex crosses.
  struct Way {
    std::vector<HalfedgeId> crossed;  ///< from right to left
    VertexId end;                     ///< the first vertex on it, if it comes to one
    HalfedgeId stop;                  ///< or the fixed edge before it
    double part = 0;                  ///< where it crosses that, of its length
  };
  /// The way from the tail of h, which begins in the face of h.
  [[nodiscard]] Way way(HalfedgeId h, VertexId to, FaceId face) const;
  /// Flips the crossed edges out of the way and improves them. Returns the edge that joins the two
  /// vertices then; invalid if rounding hinders it. O(crossed) flips as a rule, at most the square
  /// (Sloan 1993).
  HalfedgeId clear(const Way& way, VertexId from, VertexId to, FaceId face);

 private:
  using Weights = std::array<double, 3>;
  [[nodiscard]] bool is_convex(HalfedgeId h) const;
  [[nodiscard]] bool is_delaunay(HalfedgeId h) const;
  void turn(HalfedgeId h);

  SignpostTriangulation* triangulation_;
  std::function<void(HalfedgeId)> before_;
  std::unordered_set<EdgeId> fixed_;  // only looked up
};

}  // namespace talweg
