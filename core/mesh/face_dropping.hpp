// Face dropping finds the faces of raw lists that a surface does not need.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct DroppedFaces {
  std::vector<std::uint32_t> collapsed;  ///< faces that name a vertex twice; ascending
  std::vector<RepeatPlace> duplicates;   ///< faces with the vertices of an earlier face; ascending
  std::vector<std::uint32_t> zero_area;  ///< ascending
  std::vector<bool> kept;                ///< per face
};

/// Finds the faces to drop: faces that name a vertex twice, faces with the vertices of an earlier
/// face, and faces of zero area whose removal leaves no gap. No gap is left if no edge of the face
/// has exactly one other face, or if two edges of the face are boundary. Every index must be in
/// range. O(faces log degree); n flat faces at one edge cost O(n²).
DroppedFaces faces_to_drop(const MeshLists& lists);

/// The faces with the same three vertices as an earlier face, ascending; faces that are not
/// `proper` are skipped. O(faces log degree).
std::vector<RepeatPlace> duplicate_faces(const MeshLists& lists, const std::vector<bool>& proper);

}  // namespace talweg
