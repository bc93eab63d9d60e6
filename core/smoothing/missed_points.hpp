// Points that a result was to pass, and does not.
#pragma once

#include <span>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"

namespace talweg {

/// Adds a warning to the report of each curve that misses some of its way-points (by more than
/// their tolerance), pins or corners: how many, and by how much and where the worst. Only a drawing
/// that runs back over itself leads to such results. `drawn` and the results are in one order.
void warn_of_missed_points(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                           const CurveOptions& options, SmoothingResult& result);

}  // namespace talweg
