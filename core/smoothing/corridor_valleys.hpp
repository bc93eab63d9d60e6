// Valleys are the corridor's parameters for each curve of a drawing: slack, length and turns.
#pragma once

#include <vector>

#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// The valleys of a drawing: the slack of stroke_slack(), narrowed if needed to keep curves apart
/// from each other. Throws Cancelled (stage "solve"). O(n log n) for n points, plus the cost of
/// gaps_to_others().
std::vector<Corridor::Valley> valleys_of(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                         const Progress& progress);

/// The valleys with the slack and the turns of the options.
std::vector<Corridor::Valley> with_options(std::vector<Corridor::Valley> valleys,
                                           const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                           const SmoothingOptions& options);

/// The largest ε along the curve, mesh units.
double largest_slack(const Corridor::Valley& valley);

}  // namespace talweg
