// The verdict on a fair curve: it must not be worse than what it started from.
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The bending of a curve (CurveMeasures::bending with this `edge`) without its turns at corners.
/// All functions here are O(points · degree + corners).
double bending_between(const Surface& surface, const SurfaceCurve& curve,
                       std::span<const SurfacePoint> corners, double edge);

/// Whether a curve turns by `least` (radians) or more in all, without its turns at corners. Looks
/// no farther than to where it has.
bool turns_by(double least, const Surface& surface, const SurfaceCurve& curve,
              std::span<const SurfacePoint> corners);

/// No point of a fair curve turns by more, radians; corners may.
constexpr double kMostFairTurn = 5 * std::numbers::pi / 180;

/// The largest turn at one point (radians) that is no corner.
double largest_turn_between(const Surface& surface, const SurfaceCurve& curve,
                            std::span<const SurfacePoint> corners);

/// Whether a curve turns so little between corners, at each point and in each window of one `edge`
/// length (mesh units), and stays so clear of the boundary, that it is fair whatever it started
/// from.
bool is_gentle(const Surface& surface, const SurfaceCurve& curve,
               std::span<const SurfacePoint> corners, double edge);

/// Whether a fair curve lies along the boundary where the taut one at most ends there.
bool is_pressed(const Surface& surface, const SurfaceCurve& fair, const SurfaceCurve& taut);

/// Where a fair curve lies along the boundary, if it is_pressed().
std::vector<SurfacePoint> pressed_points(const Surface& surface, const SurfaceCurve& fair,
                                         const SurfaceCurve& taut);

}  // namespace talweg
