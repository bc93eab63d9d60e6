// Face turning orients the faces of raw lists consistently.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// The faces to turn so that the two faces of an edge have opposite directions along it, ascending.
/// In each part (faces joined over edges with exactly two faces) the smaller set of faces is
/// turned; if both sets have equal size, the part's first face is kept. In a one-sided part no face
/// is turned. Only `proper` faces are considered. O(faces log degree).
std::vector<std::uint32_t> faces_to_turn(const MeshLists& lists, const std::vector<bool>& proper);

}  // namespace talweg
