// Straightening may cut off detours of a drawing whose feet lie close together.
#pragma once

#include <cstddef>
#include <span>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct WithDetours {
  SurfaceCurve curve;
  std::size_t stretches = 0;  ///< of the drawing that stand in it
};

/// The taut curve with each stretch of the drawing put back that has a point farther than `far`
/// (per point of the drawing, mesh units, > 0, through space) from it. A stretch begins and ends in
/// faces that both curves pass through. Where there are none, nothing is put back. O(n log n) in
/// the points.
WithDetours with_detours(const SurfaceMesh& mesh, const SurfaceCurve& taut,
                         const SurfaceCurve& drawn, std::span<const double> far);

}  // namespace talweg
