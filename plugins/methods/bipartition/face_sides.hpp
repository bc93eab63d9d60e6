// Face sides tell on which side of drawn curves each face of a mesh lies.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

struct FaceSides {
  std::vector<char> side;  ///< per face, 0 or 1: on which it has more of its area
  bool exact = true;       ///< no face has some of its area on either side
};

/// The two sides of the curves together: whoever crosses one of them changes sides. On parts of the
/// mesh without a curve all is side 0.
/// Throws Error(kBadCurve) where there are no two such sides (a curve that ends inside the mesh, or
/// runs around a handle alone), saying where, or where no face lies mostly on one of them.
FaceSides sides_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves);

}  // namespace talweg::plugins
