// A cone detour is a straight line that passes a vertex of positive curvature on its longer side.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// An edge path from the line's first to its last point beside the line, and its vertex on whose
/// other side the line probably gets shorter.
struct ConeDetour {
  std::vector<VertexId> chain;  ///< vertices between both ends, of the faces that the line crosses
  VertexId over;                ///< one of `chain`
};

/// The vertex beside a straight line whose other side promises the largest gain; none if no side
/// promises a thousandth. A line sees the cone of a vertex under an angle; if this angle is more
/// than half of the cone's, the way on the other side is shorter, as far as the surface there is
/// the cone. `line` is a geodesic whose points lie at vertices and on crossed edges, except its
/// ends. O(faces that the line crosses and that meet at their corners).
std::optional<ConeDetour> cone_detour(SignpostTriangulation& triangulation, const Surface& surface,
                                      std::span<const SurfacePoint> line);

}  // namespace talweg
