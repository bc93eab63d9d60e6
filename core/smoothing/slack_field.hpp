// A slack field on a mesh varies the corridor's width along a drawing.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Interpolates a field of slacks per mesh vertex (mesh units, >= 0) at the drawing's points, for
/// SmoothingOptions::slack_at. Throws Error(kBadUsage) if the number of values is not the number of
/// vertices, or if a used value is not finite and >= 0. O(points).
std::vector<double> slack_along(const Surface& surface, const SurfaceCurve& drawn,
                                std::span<const double> per_vertex);

}  // namespace talweg
