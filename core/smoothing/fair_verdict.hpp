// The verdict on a fair curve: it must not be worse than what it started from.
#pragma once

#include <span>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The bending of a curve (CurveMeasures::bending with this `edge`) without its turns at corners.
double bending_between(const Surface& surface, const SurfaceCurve& curve,
                       std::span<const SurfacePoint> corners, double edge);

/// The sum of a curve's turns (radians) without those at corners.
double turning_between(const Surface& surface, const SurfaceCurve& curve,
                       std::span<const SurfacePoint> corners);

/// Whether a fair curve lies along the boundary where the taut one at most ends there.
bool is_pressed(const Surface& surface, const SurfaceCurve& fair, const SurfaceCurve& taut);

}  // namespace talweg
