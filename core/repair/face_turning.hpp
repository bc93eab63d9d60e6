// Face turning makes the faces of raw lists run the same way as their neighbours.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Finds the faces to turn so that two faces of an edge run along it in opposite ways. In each part
/// (faces joined over edges with exactly two faces) the smaller set of faces is turned; if both
/// choices turn equally many, the part's first face is kept. In a one-sided part no face is turned.
/// Only `proper` faces take part. Ascending. O(faces log degree).
std::vector<std::uint32_t> faces_to_turn(const MeshLists& lists, const std::vector<bool>& proper);

}  // namespace talweg
