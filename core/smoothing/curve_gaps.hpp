// Curve gaps are the distances between the curves of a set.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Per curve, the length of the shortest way along the surface to another curve, mesh units;
/// infinite for `limit` or more. Curves that touch, as at nodes of a network, have no gap between
/// each other. O(n log n) for n points, plus for each curve the distances to curves whose boxes are
/// within twice its gap (at most `limit`), which visit the surface between the curves. Throws
/// Cancelled (stage "solve").
std::vector<double> gaps_to_others(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                   double limit, const Progress& progress = {});

}  // namespace talweg
