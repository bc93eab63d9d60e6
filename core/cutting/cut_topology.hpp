// Cut topology tells into what kind of pieces curves divide a surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The Euler characteristics of the pieces into which curves cut a mesh, ascending: 1 for a disc, 0
/// for a ring, 2 - 2g for a closed piece of genus g. Two curves that can be moved into one another
/// without tearing give the same list; a loop that has collapsed gives another one. Open curves
/// inside the mesh do not divide it.
/// With `simple`, the part between two passages of a curve through one point is left out first (of
/// a closed curve the part with fewer points), which removes spikes and hairs of a drawing.
/// O(vertices + faces).
/// Throws Error(kBadCurve) as cut_along() does.
std::vector<std::int64_t> pieces_along(const SurfaceMesh& mesh,
                                       std::span<const SurfaceCurve> curves, bool simple);

}  // namespace talweg
