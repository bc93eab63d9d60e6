// A slack field on a mesh gives the corridor another width along each part of a drawing.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Samples a field on the mesh vertices, linear in each face, at the drawing's points, for
/// SmoothingOptions::slack_at. Throws Error(kBadUsage) when there is not one value per vertex, or a
/// value that is used is not finite and >= 0. O(points).
std::vector<double> slack_along(const Surface& surface, const SurfaceCurve& drawn,
                                std::span<const double> per_vertex);

}  // namespace talweg
