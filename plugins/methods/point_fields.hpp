// Point fields are values along a curve and over a mesh that hosts show as colours.
#pragma once

#include <span>
#include <vector>

#include "results.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/exact_distance/nearest_on_curve.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

/// Distance along the surface from each point of the result to the drawing, mesh units; infinite if
/// the drawing cannot be reached. Uses O(mesh) memory; the time grows with the number of faces
/// within the largest deviation. Throws plugin::Services::cancelled().
PointField deviation_field(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                           const SurfaceCurve& result, const plugin::Services& services);

/// Turning angle at each point, radians; 0 at the ends of an open curve.
PointField curvature_field(const SurfaceMesh& mesh, const SurfaceCurve& curve);

/// The nearest point of the curves from each vertex, along the surface. Throws
/// plugin::Services::cancelled().
std::vector<NearestOnCurve> nearest_field(const Surface& surface,
                                          std::span<const SurfaceCurve> curves,
                                          const plugin::Services& services);
/// Exact distance along the surface of each vertex to the nearest of the curves, mesh units;
/// infinite if none can be reached. Throws plugin::Services::cancelled().
std::vector<double> exact_distance_field(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         const plugin::Services& services);

/// The same for large meshes, in seconds for a million faces. Up to 100,000 vertices the distances
/// are exact. On larger meshes the 20,000 vertices nearest to the curves are exact, and
/// march_distance() continues from them with an error of about one per cent.
std::vector<double> quick_distance_field(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         const plugin::Services& services);

}  // namespace talweg::plugins
