// Sight tells which points of a drawing can be seen, and so grabbed.
#pragma once

#include <array>

#include "mesh_arrays.hpp"

namespace talweg::editing {

/// Whether the mesh lies between a point on it and the place from where one looks (mesh units; for
/// a parallel projection a place far out along the line of sight). Triangles that touch the point
/// hide nothing. Throws Error for a face that does not exist. O(triangles).
bool is_hidden(const MeshArrays& mesh, const Point& point, const std::array<double, 3>& from);

}  // namespace talweg::editing
