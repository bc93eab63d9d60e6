// Missed points are way-points, pins and corners that a result does not pass.
#pragma once

#include <span>

#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"

namespace talweg {

/// Reports missed points of each curve: way-points missed by more than their tolerance, pins and
/// corners. The report gets their number, the largest distance and its place, a warning, and the
/// termination kMissed. Points are missed if a drawing that meets itself is smoothed on a strip.
/// There, loops that are too small for the strip are erased, and parts that run back along the
/// drawing (Loops::kErase). `drawn` and the results are in the same order. O(points), and an exact
/// distance for each way-point that is not a point of the result.
void warn_of_missed_points(const SurfaceMesh& mesh, DeviationMeter& meter,
                           std::span<const SurfaceCurve> drawn, const CurveOptions& options,
                           SmoothingResult& result);

}  // namespace talweg
