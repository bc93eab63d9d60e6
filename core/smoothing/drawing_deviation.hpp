// The deviation of results from a drawing is measured where the drawing is a stroke.
#pragma once

#include <span>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Sets the deviation of each smoothed curve, and the time that measuring took. A leg is nowhere
/// near its drawing, so only strokes count where there are any, unless the result misses a point
/// between them. `legs`: those of the drawing's curves. `band`: the distance to the drawing, if it
/// is known; else null. Measuring has a budget that grows with the points unless the caller says
/// how it is measured. Throws Cancelled.
void measure_deviations(SmoothingMemory& memory, const OrderedDrawing& drawing,
                        std::span<const DrawnLegs> legs, const SmoothingOptions& options,
                        PolylineDistance* band, DomainResult& smoothed, const Progress& progress);

}  // namespace talweg
