// A measurable point has coordinates that can be worked with.
#pragma once

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// The library computes fourth powers of lengths, for which these bounds ensure numbers from 1e-72
/// to 1e72: this holds for all edges of a mesh, its size and its distance from the origin. It
/// leaves enough range for sums and sixth powers.
constexpr double kLargestCoordinate = 1e40;
constexpr double kSmallestSize = 1e-40;  ///< of the box's diagonal
constexpr double kShortestEdge = 1e-60;  ///< of edges longer than 0; no 32-bit float is shorter

/// Whether the coordinates are finite and not too large.
inline bool can_be_measured(const Point& p) {
  return (p.array().abs() <= kLargestCoordinate).all();
}

/// Whether all vertices can be measured, but for those that no face uses: they may be anywhere,
/// also nowhere (NaN). O(vertices); O(faces), too, if some cannot.
bool all_measurable(const MeshLists& lists);

/// Whether size and edges of a mesh, all of which is measurable, keep the lower bounds. A
/// mesh without any extent and edges without length are allowed.
bool large_enough(const MeshLists& lists);

}  // namespace talweg
