// Drawn curves are prepared for smoothing: corners are capped, pins checked, heat sources made.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "talweg/heat/curve_sources.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The curve with its corners capped (capping.hpp) if it runs along mesh edges and passes no vertex
/// twice; otherwise unchanged. Points in `pins` stay. O(n log n), and the cost of cap_corners().
SurfaceCurve capped_curve(const Surface& surface, const SurfaceCurve& curve,
                          std::span<const SurfacePoint> pins);

/// Throws Error(kBadUsage) naming the first pin that is not a point of one of the curves. `name` is
/// the word for the pins in the message. O(points + pins).
void check_pins(std::span<const SurfaceCurve> curves, std::span<const SurfacePoint> pins,
                std::string_view name = "pin");

/// The union of the curves as heat sources; where curves meet their weights add. Sorted by vertex.
/// O(n log n) for n points.
std::vector<WeightedVertex> sources_of(const Surface& surface,
                                       std::span<const SurfaceCurve> curves);

}  // namespace talweg
