// The verdict on a fair curve: it must not be worse than the straightened one.
#pragma once

#include <span>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Whether a fair curve bends more than the taut one (CurveMeasures::bending with this `edge`,
/// turns at corners left aside), or lies along the boundary where the taut one at most ends there.
bool is_worse(const Surface& surface, const SurfaceCurve& fair, const SurfaceCurve& taut,
              std::span<const SurfacePoint> corners, double edge);

}  // namespace talweg
