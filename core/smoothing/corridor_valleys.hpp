// Valleys hold each curve of a drawing in the corridor: how wide, how long, with which turns.
#pragma once

#include <vector>

#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// The valleys that follow from the drawing: stroke_slack(), narrowed where needed to keep each
/// curve apart from the others. Throws Cancelled (stage "solve"). O(n log n) for n points, and what
/// gaps_to_others() costs.
std::vector<Corridor::Valley> valleys_of(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                         const Progress& progress);

/// The valleys with the slack and the turns that the options ask for.
std::vector<Corridor::Valley> with_options(std::vector<Corridor::Valley> valleys,
                                           const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                           const SmoothingOptions& options);

/// The largest ε along the curve, mesh units.
double largest_slack(const Corridor::Valley& valley);

}  // namespace talweg
