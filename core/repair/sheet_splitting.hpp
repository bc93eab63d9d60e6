// Sheet splitting takes sheets of a surface apart where it is no manifold.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/mesh_sides.hpp"

namespace talweg {

struct Sheets {
  /// Per corner (3 face + corner) the smallest corner of its fan; corners of one vertex in
  /// different fans need vertices of their own.
  std::vector<std::uint32_t> fan_of_corner;
  std::vector<std::vector<FaceSide>> crowded;  ///< edges with more than two faces
};

/// Cuts a surface along edges with more than two faces and at vertices with more than one fan
/// (Gueziec, Taubin, Lazarus & Horn 2001, "Cutting and stitching"). At an edge, faces that run
/// along it in opposite directions stay joined in pairs, the flattest pair first; the others get a
/// boundary there. An edge where that leaves more than two faces between the same two vertices, or
/// with more than sixteen faces, is cut wholly. Faces that are not `proper` are left out; corners
/// of theirs are fans of their own.
Sheets split_sheets(const MeshLists& lists, const std::vector<bool>& proper);

}  // namespace talweg
