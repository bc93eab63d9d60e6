// Surface normals are those of the mesh at the points of a curve.
#pragma once

#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// The unit normal of the mesh at a point, on the side from which faces are counterclockwise:
/// inside a face the normal of the face, on an edge the mean of both faces, and at a vertex the
/// mean of its faces weighted by their angles. Zero where all these faces have no area. O(degree).
Point normal_at(const SurfaceMesh& mesh, const SurfacePoint& point);

/// Sets the normals of a placed curve's points. O(points · degree).
void set_normals(const SurfaceMesh& mesh, PlacedCurve& curve);

}  // namespace talweg
