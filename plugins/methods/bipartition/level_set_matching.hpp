// Matching tells which curve of a level set belongs to which drawn curve.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

struct MatchedCurves {
  std::vector<SurfaceCurve> curves;  ///< one per drawn curve, running and beginning as it does
  std::vector<SurfaceCurve> others;  ///< that belong to none
};

/// Gives every drawn curve the curve of the set, closed as it is, that its points are nearest to in
/// the mean (through space); the nearest pairs first.
/// Throws Error(kNumerical) naming a drawn curve for which none is left.
MatchedCurves match(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                    std::vector<SurfaceCurve> set);

}  // namespace talweg::plugins
