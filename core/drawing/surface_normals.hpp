// Surface normals are those of the mesh at the points of a curve.
#pragma once

#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// The unit normal of the mesh at a point, to the side from which faces are counterclockwise: of
/// the face that it is in, the mean of both at an edge, and around a vertex weighted by the faces'
/// angles. Zero where all faces are flat. O(degree).
Point normal_at(const SurfaceMesh& mesh, const SurfacePoint& point);

/// Sets the normals of a placed curve's points. O(points · degree).
void set_normals(const SurfaceMesh& mesh, PlacedCurve& curve);

}  // namespace talweg
