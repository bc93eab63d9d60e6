// Control points of a curve count as clicks if they are few and far apart.
#pragma once

#include <span>
#include <string>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Bounds for control points that count as clicks: their largest number on a curve, and their least
/// mean distance in mean edges.
constexpr std::size_t kMostControlPoints = 200;
constexpr double kLeastSpacing = 2;

/// An empty text if a curve's control points can have been clicked; otherwise a sentence that says
/// why they are a stroke. `points` are the control points on the mesh; h in the sentence is the
/// mean edge length near them. O(points), at most 200 of which are looked at.
std::string why_no_clicks(const SurfaceMesh& mesh, std::span<const SurfacePoint> points,
                          bool closed);

}  // namespace talweg
