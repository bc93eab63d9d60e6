// Curve sources are the vertices at which the heat of a curve starts, with their weights.
#pragma once

#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A vertex of a source set. Only the ratios of weights within one component matter.
struct WeightedVertex {
  VertexId vertex;    ///< of the surface
  double weight = 1;  ///< >= 0, finite

  friend bool operator==(const WeightedVertex&, const WeightedVertex&) = default;
};

/// The source set of a curve: vertex i has the weight ∫ λᵢ ds along the curve, where λᵢ is its hat
/// function in the triangles of the surface. So a curve vertex gets half the lengths of its two
/// segments, and points on edges or in faces distribute their weight over the corners. The weights
/// sum to the curve's length. A curve of length 0 (one point) gets its points' barycentrics
/// instead, each point weighing 1. Sorted by vertex, weights > 0. O(curve).
/// Throws Error(kBadCurve) when the curve is empty or two consecutive points have no common face.
std::vector<WeightedVertex> curve_sources(const Surface& surface, const SurfaceCurve& curve);

}  // namespace talweg
