// Sheet splitting cuts a surface along non-manifold edges and vertices into manifold sheets.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/mesh_sides.hpp"

namespace talweg {

struct Sheets {
  /// Per corner (3 face + corner), the smallest corner of its fan. Corners of one vertex in
  /// different fans need separate vertices.
  std::vector<std::uint32_t> fan_of_corner;
  std::vector<std::vector<FaceSide>> crowded;  ///< edges with more than two faces
};

/// Cuts a surface along edges with more than two faces and at vertices with more than one fan
/// (Gueziec, Taubin, Lazarus & Horn 2001, "Cutting and stitching"). At an edge, pairs of faces with
/// opposite directions stay joined, the flattest pair first; unpaired faces get a boundary. An edge
/// is cut completely if it has more than sixteen faces, or if joined pairs leave more than two
/// faces between the same two vertices. Faces that are not `proper` are ignored; each of their
/// corners is a separate fan. O(faces log degree), in up to five rounds.
Sheets split_sheets(const MeshLists& lists, const std::vector<bool>& proper);

}  // namespace talweg
