// A smooth ground is a mesh without the noise of its scan.
#pragma once

#include <span>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// In edge lengths: a surface with a smaller roughness σ counts as smooth. Clean scans and CAD stay
/// below this limit.
constexpr double kLeastRoughness = 0.04;

/// The roughness σ of the mesh along curves: the root mean square of the noise of vertices along
/// the normal, in local edge lengths. At a vertex, σ² ∝ (4 d₂² − d₄²) / 3, where d_s is the root
/// mean square, over the surroundings, of the part finer than s edges (finer_parts()), along the
/// normal of the surface without its parts finer than 4 edges. For noise, d₂ and d₄ are nearly
/// equal. At a crease d₄ = 2 d₂, on a curved surface d₄ is larger, so σ = 0. The result is the
/// upper quartile of σ over 24 vertices along the curves; 0 if fewer than 200 vertices are near,
/// because so few cannot tell noise from shape. O(points + vertices within eight edges of the 24),
/// and an array over all vertices. Throws Cancelled.
double roughness_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                       const Progress& progress = {});

/// The mesh with each vertex moved along the normal of its surroundings, which removes the parts
/// finer than 10 √(σ − kLeastRoughness) edges, at most 6 edges. Vertices with σ <= kLeastRoughness
/// stay exactly in place. Vertices do not move along the surface, so a curve that is fair on the
/// smooth ground is also fair on the mesh when seen along the normal. O(mesh). Throws Cancelled.
SurfaceMesh smooth_ground(const SurfaceMesh& mesh, const Progress& progress = {});

}  // namespace talweg
