// Curve gaps tell how far apart the curves of a set are.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Per curve the length of the shortest way along the surface to another curve, mesh units;
/// infinite where that is `limit` or more. Curves that touch (at nodes of a network) do not count
/// for each other. O(n log n) for n points in all, and what is measured: for each curve those whose
/// boxes may be within twice its gap, their segments beside its box times log n, and the band
/// between them on the surface; as far as `limit` where a curve has no gap. Throws Cancelled when
/// `progress` (stage "solve") says so.
std::vector<double> gaps_to_others(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                   double limit, const Progress& progress = {});

}  // namespace talweg
