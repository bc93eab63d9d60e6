// Tagged edges are the edges of a mesh along curves, with the number of the curve.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {

/// The edges of the triangles along curves, ordered by curve and along the curve; at an opened
/// seam, both edges. `curves` belong to the origins of these triangles. O(triangles).
std::vector<TaggedEdge> tagged_edges(std::span<const Triangle> triangles,
                                     std::span<const PartOrigins::Curve> curves);

}  // namespace talweg
