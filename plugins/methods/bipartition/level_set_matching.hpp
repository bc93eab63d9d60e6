// Matching tells which curve of a level set belongs to which drawn curve.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

struct MatchedCurves {
  std::vector<SurfaceCurve> curves;  ///< one per drawn curve, with its direction and start
  std::vector<SurfaceCurve> others;  ///< curves that match no drawn curve
};

/// Assigns to every drawn curve the curve of the set, closed if it is closed, to which its points
/// are nearest on average (through space); the nearest pairs are assigned first.
/// Throws Error(kNumerical), which names the drawn curve, if the set has no curve left for it.
MatchedCurves match(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                    std::vector<SurfaceCurve> set);

}  // namespace talweg::plugins
