// A measurable point has coordinates that can be worked with.
#pragma once

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Fourth powers of lengths are computed, which are numbers from 1e-72 to 1e72. Within these bounds
/// they are of all edges of a mesh, of its size and of its distance from the origin, and much is
/// left for sums and sixth powers.
constexpr double kLargestCoordinate = 1e40;
constexpr double kSmallestSize = 1e-40;  ///< of the box's diagonal
constexpr double kShortestEdge = 1e-60;  ///< of those that are not 0; 32-bit floats have no shorter

/// Finite, and not too large.
inline bool can_be_measured(const Point& p) {
  return (p.array().abs() <= kLargestCoordinate).all();
}

/// Whether size and edges of a mesh, whose points can all be measured, keep the lower bounds; a
/// mesh without any extent and edges without length do.
bool large_enough(const MeshLists& lists);

}  // namespace talweg
