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

/// Orders vertices into curves. Neighbours on the mesh follow each other. Chains of neighbours and
/// single vertices are then joined at their ends where the fewest edges lie between them, shortest
/// joints first, but never by a joint more than four times as long as the longest one in the chain.
/// A chain of at least three vertices whose ends are as near to each other as its other members is
/// closed, and nothing is joined to it. Remaining single vertices make no curve. An open curve
/// begins at its end with the smaller number, a closed one at its smallest vertex.
///
/// Throws Error naming a vertex where neighbours branch or form a cluster, so that they have no
/// order, and for a vertex that the mesh does not have. O(mesh).
std::vector<OrderedVertices> order_along_mesh(const MeshArrays& mesh,
                                              const std::vector<std::uint32_t>& vertices);

/// The same for edges, given by their two vertices: only these edges join vertices.
/// Throws Error where three of them meet.
std::vector<OrderedVertices> order_along_edges(
    const std::vector<std::array<std::uint32_t, 2>>& edges);

/// The same for edges that may branch, as borders between several regions do: curves end where
/// other than two edges meet, and every edge belongs to one curve.
std::vector<OrderedVertices> order_between_branches(
    const std::vector<std::array<std::uint32_t, 2>>& edges);

}  // namespace talweg::editing
