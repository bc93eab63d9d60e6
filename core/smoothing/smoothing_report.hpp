// The report on a smoothing is made once, at the end, on the mesh that was given.
#pragma once

#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"

namespace talweg {

/// The smoothed curves, which are on the mesh, with a report on each, in the drawing's order. The
/// total is left to the caller.
SmoothingResult reported(const OpenedMesh& mesh, const OrderedDrawing& drawing,
                         const SmoothingOptions& options, DomainResult smoothed);

/// The drawing as it was drawn, with reports that say that it was not smoothed. The options are
/// those for the curves as drawn.
SmoothingResult cancelled_result(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                 const SmoothingOptions& options);

/// The report on a curve of which a part is being dragged: its measures are new, the rest is as in
/// `before`. The options are those of this curve. Throws Cancelled.
SmoothingReport preview_report(const SurfaceMesh& mesh, DeviationMeter& meter,
                               const SurfaceCurve& drawn, const SurfaceCurve& result,
                               const SmoothingOptions& options, const SmoothingReport& before,
                               const Progress& progress);

}  // namespace talweg
