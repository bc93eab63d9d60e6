// Control points of a curve can have been clicked if they are few and far apart.
#pragma once

#include <span>
#include <string>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A curve has at most so many control points that were clicked, and they lie on average at least
/// so many mean edges apart.
constexpr std::size_t kMostControlPoints = 200;
constexpr double kLeastSpacing = 2;

/// An empty text if a curve's control points can have been clicked; otherwise a sentence on why
/// they are a stroke. `points` are those on the mesh, and h is the mean edge length near them.
/// O(points), of which there are at most 200.
std::string why_no_clicks(const SurfaceMesh& mesh, std::span<const SurfacePoint> points,
                          bool closed);

}  // namespace talweg
