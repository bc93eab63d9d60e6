// Faces are dropped from raw lists where a surface does without them.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct DroppedFaces {
  std::vector<std::uint32_t> collapsed;  ///< faces that name a vertex twice; ascending
  std::vector<RepeatPlace> duplicates;   ///< faces that repeat an earlier one; ascending
  std::vector<std::uint32_t> zero_area;  ///< ascending
  std::vector<bool> kept;                ///< per face
};

/// Finds faces that name a vertex twice, repeat the vertices of an earlier one, or have zero area
/// and leave no gap when dropped: none of their edges has just one other face, or only one edge
/// joins them to the rest at the boundary. Every index must be in range. O(faces log degree).
/// Worse: many flat faces at one edge, the square of their number.
DroppedFaces faces_to_drop(const MeshLists& lists);

/// Faces with the same three vertices as an earlier one; faces that are not `proper` are skipped.
/// Ascending. O(faces log degree).
std::vector<RepeatPlace> duplicate_faces(const MeshLists& lists, const std::vector<bool>& proper);

}  // namespace talweg
