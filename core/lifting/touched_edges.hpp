// Touched edges are the edges whose lengths a straightening has read, with their largest distance
// from the curves.
#pragma once

#include <span>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct TouchedEdges {
  double farthest = 0;  ///< mesh units: no end of an edge is farther from the curves than this
  double shortest = 0;  ///< mesh units: the length of the shortest edge
};

/// Covers all edges of the faces around the vertices `touched`; inserted vertices, which lie on the
/// curves, are skipped. Uses Dijkstra's algorithm from the curves over these edges alone: paths
/// along edges are at least as long as the distance. `farthest` is infinite where the edges are not
/// connected with the curves. O(touched, log). Throws Cancelled when `progress` (stage
/// "straighten") returns false.
TouchedEdges touched_edges(const Surface& surface, std::span<const VertexId> touched,
                           std::span<const SurfaceCurve> curves, const Progress& progress = {});

}  // namespace talweg
