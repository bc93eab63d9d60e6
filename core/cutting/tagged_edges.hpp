// Tagged edges are those of a mesh that curves run along.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {

/// The edges of the triangles that belong to a chain, by curve and along it; where a seam has been
/// opened, both edges. `from`: for each vertex of these triangles, its number in the chains.
/// O(triangles).
std::vector<TaggedEdge> tagged_edges(std::span<const Triangle> triangles,
                                     std::span<const std::uint32_t> from,
                                     std::span<const CutMesh::Chain> chains);

}  // namespace talweg
