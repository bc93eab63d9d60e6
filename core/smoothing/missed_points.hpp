// Points that a result was to pass, and does not.
#pragma once

#include <span>

#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"

namespace talweg {

/// Adds a warning to the report of each curve, and ends it as Outcome::kMissed, that misses some
/// of its way-points (by more than their tolerance), pins or corners: how many, and by how much and
/// where the worst. That happens where a drawing that meets itself is smoothed on a strip: loops
/// too small to be laid out there, and ways back, are left out (Loops::kErase). `drawn` and the
/// results are in one order. O(points), and an exact distance for each way-point that is no point
/// of the result.
void warn_of_missed_points(const SurfaceMesh& mesh, DeviationMeter& meter,
                           std::span<const SurfaceCurve> drawn, const CurveOptions& options,
                           SmoothingResult& result);

}  // namespace talweg
