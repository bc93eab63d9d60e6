// Corner coordinates name a point by three vertices and weights, without a face.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The face of smallest id that has all vertices whose weight is not 0; invalid if there is none.
/// O(degree).
FaceId any_face(const Surface& surface, const CornerCoordinates& at);

/// The points as coordinates in faces of the mesh. Weights are divided by their sum. Throws
/// Error(kBadCurve) naming the position in the curve (from 0) for a vertex that does not exist,
/// vertices without a common face, and weights that are negative or all 0.
std::vector<FaceCoordinates> in_faces(const Surface& surface,
                                      const std::vector<CornerCoordinates>& points);

/// The same in a list of triangles that need not be a surface, as before a repair. `vertices` is
/// the number of vertices. Also throws Error(kBadMesh) for a triangle that names a vertex beyond
/// that number. O(triangles + degree).
std::vector<FaceCoordinates> in_faces(std::span<const Triangle> triangles, std::size_t vertices,
                                      const std::vector<CornerCoordinates>& points);

}  // namespace talweg
