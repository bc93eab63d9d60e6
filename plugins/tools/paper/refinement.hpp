// Refines parts of a mesh, and makes a disc for tests of refinement.
#pragma once

#include <cstdint>
#include <functional>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::paper {

/// Divides every face whose middle is picked into four at its edges' midpoints; its neighbours are
/// divided into two or three as needed, so that no vertex lies on an edge. O(faces log faces).
MeshLists refined(const MeshLists& mesh, const std::function<bool(const Point& middle)>& pick);

/// The flat unit disc as `rings` rings of vertices, inner vertices moved a little at random: 6
/// rings² faces, normals along z. rings >= 1.
MeshLists disc(std::uint32_t rings);

}  // namespace talweg::paper
