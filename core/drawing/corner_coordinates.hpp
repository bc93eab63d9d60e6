// Corner coordinates name a point by vertices and weights; on a mesh they become those of a face.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The face of smallest id at all vertices whose weight is not 0; invalid if there is none.
/// O(degree).
FaceId any_face(const Surface& surface, const CornerCoordinates& at);

/// The points in faces of the mesh. Weights are divided by their sum. Throws Error(kBadCurve)
/// naming the position in the curve (from 0) for a vertex that does not exist, vertices that are of
/// no common face, and weights that are negative or all 0.
std::vector<FaceCoordinates> in_faces(const Surface& surface,
                                      const std::vector<CornerCoordinates>& points);

/// The same in a mesh that need not be a surface, as where it will be repaired. `vertices` is their
/// number. Also throws Error(kBadMesh) for a triangle with a vertex beyond it. O(triangles +
/// degree).
std::vector<FaceCoordinates> in_faces(std::span<const Triangle> triangles, std::size_t vertices,
                                      const std::vector<CornerCoordinates>& points);

}  // namespace talweg
