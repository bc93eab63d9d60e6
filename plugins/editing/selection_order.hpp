// The selection order is the order of selected vertices along a curve on the mesh.
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

/// Orders vertices into curves. Selected neighbours on the mesh are joined first. A joint is a path
/// of edges between two selected vertices. Chains of neighbours and single vertices are then joined
/// at their ends, joints with the fewest edges first, but never by a joint with more than four
/// times as many edges as the longest joint in the chain. A chain of at least three vertices is
/// closed if the joint between its ends is no longer than its longest joint; nothing is joined to a
/// closed chain. Remaining single vertices make no curve. An open curve begins at its end with the
/// smaller number, a closed curve at its smallest vertex.
///
/// Throws Error, which names a vertex, where neighbours branch or form a cluster and so have no
/// order, and for a vertex that the mesh does not have. O(mesh).
std::vector<OrderedVertices> order_along_mesh(const MeshArrays& mesh,
                                              const std::vector<std::uint32_t>& vertices);

/// Orders the vertices of edges into curves. An edge is given by its two vertices. Throws Error
/// where three edges meet, and for an edge between a vertex and itself.
std::vector<OrderedVertices> order_along_edges(
    const std::vector<std::array<std::uint32_t, 2>>& edges);

/// Orders the vertices of edges that may branch, as borders between several regions do. Every edge
/// belongs to one curve. Curves end at vertices with other than two edges. Throws Error for an edge
/// between a vertex and itself.
std::vector<OrderedVertices> order_between_branches(
    const std::vector<std::array<std::uint32_t, 2>>& edges);

}  // namespace talweg::editing
