// The selection order is that in which selected vertices lie along the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh_arrays.hpp"

namespace talweg::editing {

struct OrderedVertices {
  std::vector<std::uint32_t> vertices;
  bool closed = false;

  bool operator==(const OrderedVertices&) const = default;
};

/// Orders vertices into curves. Neighbours on the mesh follow each other. Chains of them and single
/// vertices are then joined at their ends where the fewest edges lie between, shortest joints
/// first, but none by more than four times the longest joint that it has. A chain whose ends are as
/// near as its members is closed, from three vertices on, and nothing is joined to it. Single
/// vertices that are left make no curve. An open curve begins at its end of smaller number, a
/// closed one at its smallest vertex.
///
/// Throws Error where neighbours branch or lie in a heap, so that they have no order, naming a
/// vertex; and for one that the mesh does not have. O(mesh).
std::vector<OrderedVertices> order_along_mesh(const MeshArrays& mesh,
                                              const std::vector<std::uint32_t>& vertices);

/// The same for edges, given by their two vertices: only these edges join.
/// Throws Error where three of them meet.
std::vector<OrderedVertices> order_along_edges(
    const std::vector<std::array<std::uint32_t, 2>>& edges);

}  // namespace talweg::editing
