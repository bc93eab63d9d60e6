// Tagged edges are those of a mesh that curves run along.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {

/// The edges of the triangles that are those of a chain, by curve, along it; both where a seam has
/// been opened. `from`: of each vertex of these triangles, its number in the chains. O(triangles).
std::vector<TaggedEdge> tagged_edges(std::span<const Triangle> triangles,
                                     std::span<const std::uint32_t> from,
                                     std::span<const CutMesh::Chain> chains);

}  // namespace talweg
