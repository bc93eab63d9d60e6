// Tagged edges are those of a mesh that curves run along.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {

/// The edges of the triangles that curves run along, by curve and along it; where a seam has been
/// opened, both edges. `curves`: of the origins of these triangles. O(triangles).
std::vector<TaggedEdge> tagged_edges(std::span<const Triangle> triangles,
                                     std::span<const PartOrigins::Curve> curves);

}  // namespace talweg
