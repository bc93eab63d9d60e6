// Face sides tell on which side of drawn curves each face of a mesh lies.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

struct FaceSides {
  std::vector<char> side;  ///< per face, 0 or 1: the side with more of its area
  bool exact = true;       ///< whether no face has area on both sides
};

/// The two sides that all curves together separate: crossing any curve changes the side. Parts of
/// the mesh without a curve are on side 0.
/// Throws Error(kBadCurve) if there are no two such sides (a curve ends inside the mesh, or runs
/// around a handle alone), saying where, or if no face lies mostly on one of them.
FaceSides sides_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves);

}  // namespace talweg::plugins
