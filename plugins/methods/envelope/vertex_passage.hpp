// A vertex passage describes how a curve passes a vertex of the mesh: the vertex's edges on either
// side of the curve, and the angles there.
#pragma once

#include <array>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

/// One side of a passage a, v, b: the edges between a and b there.
struct PassageSide {
  double angle = 0;  ///< radians, between the directions to a and to b; infinite beyond a boundary
  struct Spoke {
    HalfedgeId halfedge;  ///< leaves v
    double chord = 0;     ///< distance from v to the straight line from a to b, mesh units
  };
  std::vector<Spoke> spokes;  ///< in the order from a to b; chords only where angle < pi
};

/// Both sides of v between a and b, which are points other than v in faces at v. The faces about v
/// are unfolded. O(degree).
std::array<PassageSide, 2> passage_at(const Surface& surface, VertexId v, const SurfacePoint& a,
                                      const SurfacePoint& b);

}  // namespace talweg::plugins
