// Face turning makes the faces of raw lists run the same way as their neighbours.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Finds the faces to turn around so that two faces of an edge run along it in opposite ways.
/// Of each part (faces joined over edges with exactly two faces) the fewer are turned; where both
/// choices turn as many, the part's first face is kept. None of a one-sided part is.
/// Only `proper` faces take part. Ascending.
std::vector<std::uint32_t> faces_to_turn(const MeshLists& lists, const std::vector<bool>& proper);

}  // namespace talweg
