// An edge path runs along edges of a triangulation, tip to tail.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// At least one halfedge, each ending where the next one starts; a closed path's last one ends
/// where its first one starts. One-edge loops and repeated edges are allowed.
class EdgePath {
 public:
  /// Throws Error(kBadCurve) naming the first position where the chain is empty or broken.
  static EdgePath make(const SignpostTriangulation& triangulation,
                       std::vector<HalfedgeId> halfedges, bool closed);

  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] std::span<const HalfedgeId> halfedges() const { return halfedges_; }

 private:
  friend class PathNetwork;
  EdgePath(std::vector<HalfedgeId> halfedges, bool closed)
      : halfedges_(std::move(halfedges)), closed_(closed) {}

  std::vector<HalfedgeId> halfedges_;
  bool closed_;
};

/// The path's length in the triangulation's present metric.
double path_length(SignpostTriangulation& triangulation, const EdgePath& path);

}  // namespace talweg
