// The polygons of a part are what the file's polygons became when the mesh was cut.
#pragma once

#include <span>

#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// The faces of a part as polygons. Polygons of the file that no curve has cut are whole again. A
/// polygon that was cut becomes the polygons between the curves if it is plane (its corners within
/// 1e-9 of its size), otherwise triangles, so that the surface stays what it was. So do what a
/// curve ends in, and what is no disc. All other faces are triangles.
///
/// `origins`: of this part, with the numbers of the file whose polygons `of_file` has. Faces come
/// in the order of their first triangles. O(faces log faces).
FaceOutlines polygons_of(const MeshPart& part, const PartOrigins& origins,
                         std::span<const Polygon> of_file);

}  // namespace talweg
