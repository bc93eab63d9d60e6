// Flips make a triangulation intrinsic Delaunay.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A triangle known by its corners and side lengths; side k runs from corner k to corner k + 1.
struct MetricTriangle {
  std::array<VertexId, 3> corner;
  std::array<double, 3> length;
};

/// The triangles of a surface, unchanged.
std::vector<MetricTriangle> metric_triangles(const Surface& surface);

/// The triangles of the intrinsic Delaunay triangulation of the surface: same vertices, same
/// metric, cotan weights of all inner edges >= 0 up to rounding (Bobenko & Springborn 2007).
/// `flips`, if given, receives the number of flips. Edges that no flip can improve (in zero-area
/// diamonds) stay as they are, so the algorithm always ends. O(faces + flips).
std::vector<MetricTriangle> delaunay_triangles(const Surface& surface,
                                               std::size_t* flips = nullptr);

}  // namespace talweg
