// The drawing deviation is measured between the strokes of a drawing and of its result.
#pragma once

#include <span>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Sets the deviation of each smoothed curve, and the time of measuring. A leg need not be near its
/// drawing, so a curve with strokes is measured on its strokes only, unless the result misses a
/// point between legs and strokes. `legs`: per curve of the drawing. `band`: a distance set to the
/// drawing, or null. With DeviationMeasure::kAutomatic and without a caller's budget, the work is
/// limited in proportion to the points. Throws Cancelled.
void measure_deviations(SmoothingMemory& memory, const OrderedDrawing& drawing,
                        std::span<const DrawnLegs> legs, const SmoothingOptions& options,
                        PolylineDistance* band, DomainResult& smoothed, const Progress& progress);

}  // namespace talweg
