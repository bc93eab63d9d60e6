// Level sets of functions on the vertices, used as closed drawings.
#pragma once

#include <functional>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::quality {

/// The closed level sets f = 0 of a function given at the vertices, each as the vertices nearest
/// to its crossings of mesh edges, in order, the longest first. Level sets that run into the
/// boundary are left out. O(faces).
std::vector<std::vector<VertexId>> closed_level_sets(const SurfaceMesh& mesh,
                                                     const std::function<double(const Point&)>& f);

}  // namespace talweg::quality
