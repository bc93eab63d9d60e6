// A measurable point has coordinates whose powers stay in the range of doubles.
#pragma once

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Bounds of lengths for which the library's fourth powers, sums and sixth powers of lengths stay
/// in the range of doubles. The lengths are the edges of a mesh, its size and its distance from the
/// origin.
constexpr double kLargestCoordinate = 1e40;
constexpr double kSmallestSize = 1e-40;  ///< of the bounding box's diagonal
constexpr double kShortestEdge = 1e-60;  ///< of edges longer than 0; no 32-bit float is shorter

/// Whether the coordinates are finite and not too large.
inline bool can_be_measured(const Point& p) {
  return (p.array().abs() <= kLargestCoordinate).all();
}

/// Whether all vertices of faces can be measured; vertices without a face may have any coordinates,
/// also NaN. O(vertices), and O(faces) if some vertex cannot be measured.
bool all_measurable(const MeshLists& lists);

/// Whether the size and the edges of a measurable mesh are not below the lower bounds. A size of 0
/// and edges of length 0 are allowed.
bool large_enough(const MeshLists& lists);

}  // namespace talweg
