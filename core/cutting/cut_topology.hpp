// Cut topology tells into what kind of pieces curves divide a surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The Euler characteristics of the pieces that a mesh falls into along curves, ascending: 1 for a
/// disc, 0 for a ring, 2 - 2g for a closed piece of genus g. Two curves that can be moved into one
/// another without tearing leave the same list, a loop that has collapsed does not. Open curves
/// inside the mesh leave it whole.
/// With `simple` what lies between two passages of a curve through one point is left out first, of
/// a closed curve the part of fewer points: spikes and hairs of a drawing. O(vertices + faces).
/// Throws Error(kBadCurve) as cut_along() does.
std::vector<std::int64_t> pieces_along(const SurfaceMesh& mesh,
                                       std::span<const SurfaceCurve> curves, bool simple);

}  // namespace talweg
