// Fair measures decide whether a curve is fair: bending, turns, and points at the boundary.
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

/// Whether a curve turns by `least` (radians) or more in all, without its turns at corners. Stops
/// at the point where the sum reaches `least`.
bool total_turn_reaches(double least, const Surface& surface, const SurfaceCurve& curve,
                        std::span<const SurfacePoint> corners);

/// The largest turn at a point of a fair curve that is not a corner, radians.
constexpr double kMostFairTurn = 5 * std::numbers::pi / 180;

/// The largest turn (radians) at a point that is not a corner.
double largest_turn_between(const Surface& surface, const SurfaceCurve& curve,
                            std::span<const SurfacePoint> corners);

/// Whether a curve is fair without a comparison: between corners it turns little, at each point and
/// in each window of one `edge` length (mesh units), and only its ends may be at the boundary.
bool is_clearly_fair(const Surface& surface, const SurfaceCurve& curve,
                     std::span<const SurfacePoint> corners, double edge);

/// Whether a fair curve has more points at the boundary than the taut curve, which has at most two.
bool has_more_boundary_points(const Surface& surface, const SurfaceCurve& fair,
                              const SurfaceCurve& taut);

/// The points of a fair curve at the boundary if it has_more_boundary_points(), else none.
std::vector<SurfacePoint> boundary_points_of(const Surface& surface, const SurfaceCurve& fair,
                                             const SurfaceCurve& taut);

}  // namespace talweg
