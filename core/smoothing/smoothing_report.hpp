// The smoothing report is made once, at the end, on the given mesh.
#pragma once

#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"

namespace talweg {

/// The measures of a curve on the smooth ground, but with the length and the tortuosity of
/// `on_mesh`, its measures on the mesh. `edge` is that of measure_curve().
CurveMeasures turns_on_ground(const SurfaceMesh& ground, const SurfaceCurve& curve, double edge,
                              const CurveMeasures& on_mesh);

/// The smoothed curves, which must be on the mesh, with a report on each, in the drawing's order.
/// The total is not set.
SmoothingResult reported(const OpenedMesh& mesh, const OrderedDrawing& drawing,
                         const SmoothingOptions& options, DomainResult smoothed);

/// The result of a cancelled smoothing: the drawn curves, with the termination kCancelled.
/// `options` are for the curves in drawn order.
SmoothingResult cancelled_result(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                 const SmoothingOptions& options);

/// The report on a curve while a part of it is dragged: measures are new, other values are those of
/// `before`. `options` are those of this curve (SmoothingOptions::of()). Throws Cancelled.
SmoothingReport preview_report(const SurfaceMesh& mesh, DeviationMeter& meter,
                               const SurfaceCurve& drawn, const SurfaceCurve& result,
                               const SmoothingOptions& options, const SmoothingReport& before,
                               const Progress& progress);

}  // namespace talweg
