// A smooth ground is a mesh without the roughness of its scan.
#pragma once

#include <span>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// In edge lengths: what is less rough counts as smooth. Clean scans and CAD stay below it.
constexpr double kLeastRoughness = 0.04;

/// How rough the mesh is along curves, in edge lengths there: the root mean square of what its
/// vertices lie off the surface that they mean, where that is a noise. A vertex is rough by σ with
/// σ² = (4 d₂² − d₄²) / 3, where d_s is the root mean square over its surroundings of what is finer
/// than s edges (finer_parts()), along the normal of the surface that is left at 4 edges. Of noise,
/// d₂ and d₄ are nearly the same; at a crease d₄ is twice d₂, on a bent surface more, and nothing
/// is left. The upper quartile over 24 vertices along the curves counts;
/// 0 where fewer than 200 vertices are near, which cannot tell noise from shape. O(vertices within
/// eight edges of these, and points), and a number for each vertex of the mesh is set to 0. Throws
/// Cancelled.
double roughness_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                       const Progress& progress = {});

/// The same faces with each vertex moved along the normal of the surface around it, so that what is
/// finer than 8 √(σ − kLeastRoughness) edges is gone, up to 6 edges; vertices that are less rough
/// stay exactly where they are. Since vertices do not move along the surface, a curve that is fair
/// there is also fair here as it is seen from outside. O(mesh). Throws Cancelled.
SurfaceMesh smooth_ground(const SurfaceMesh& mesh, const Progress& progress = {});

}  // namespace talweg
