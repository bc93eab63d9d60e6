// Valleys hold each curve of a drawing in the corridor: how wide, how long, with which turns.
#pragma once

#include <functional>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/corridor.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// As the drawing asks for: default_slack(), but narrow enough to keep each curve from the others.
/// Throws Cancelled (stage "solve").
std::vector<Corridor::Valley> valleys_of(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                         const Progress& progress);

/// Narrows the valleys of loops that collapse within their own corridor: those that are thin, or
/// small against their slack. Whether one does is tried, at tau = 1/4, the smallest at which it
/// must not: `smooth` smooths in these valleys. Where no slack holds a loop its valley is steeper,
/// too.
void hold_loops(std::vector<Corridor::Valley>& valleys, const SurfaceMesh& mesh,
                const OrderedDrawing& drawing,
                const std::function<Smoothed(const SmoothingOptions&)>& smooth);
/// Whether one of them is in doubt, so that hold_loops() would try.
bool has_doubtful_loop(const std::vector<Corridor::Valley>& valleys, const SurfaceMesh& mesh,
                       const OrderedDrawing& drawing);

/// With the slack and the turns that are asked for.
std::vector<Corridor::Valley> with_options(std::vector<Corridor::Valley> valleys,
                                           const OrderedDrawing& drawing,
                                           const SmoothingOptions& options);

/// The largest ε along the curve, mesh units.
double largest_slack(const Corridor::Valley& valley);

}  // namespace talweg
