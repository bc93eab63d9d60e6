// Cut topology describes the pieces into which curves divide a surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The Euler characteristics of the pieces into which curves cut a mesh, ascending: 1 for a disc, 0
/// for an annulus, 2 - 2g for a closed piece of genus g. Two curves that can be deformed into each
/// other give the same list; a loop that has collapsed gives another list. Open curves inside the
/// mesh do not divide it. With `simple`, the part of a curve between two passages of one point is
/// removed first (of a closed curve the part with fewer points), which removes spikes of a drawing.
/// O(vertices + faces). Throws Error(kBadCurve) as cut_along() does.
std::vector<std::int64_t> pieces_along(const SurfaceMesh& mesh,
                                       std::span<const SurfaceCurve> curves, bool simple);

}  // namespace talweg
