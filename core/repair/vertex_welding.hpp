// Welding finds which vertices of raw lists are one and the same.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct Welding {
  std::vector<std::uint32_t> onto;  ///< per vertex the smallest one of its group
  double tolerance = 0;             ///< mesh units
};

/// Groups vertices of faces that lie at the same position, or close together: within two units in
/// the last place of the mesh's largest coordinate (of 32-bit floats where the file stores those)
/// and within a quarter of the shortest edge of positive length at either vertex. The second bound
/// keeps neighbours on a coarsely rounded mesh apart. Vertices in no face stay alone. Every index
/// must be in range and every coordinate finite. O(vertices log vertices).
Welding weld_vertices(const MeshLists& lists);

}  // namespace talweg
