// The polygons of a part are the polygons of the file, divided by the cut.
#pragma once

#include <span>

#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// The faces of a part as polygons. A polygon of the file that no curve has cut is whole. A cut
/// polygon becomes the polygons between the curves if it is plane (corners within 1e-9 of its
/// size), otherwise triangles, so the surface does not change. A piece of a polygon in which a
/// curve ends, or which is not a disc, also becomes triangles. All other faces are triangles.
///
/// `origins` are the origins of this part in the file with the polygons `of_file`. Faces are
/// ordered by their first triangles. O(faces log faces).
FaceOutlines polygons_of(const MeshPart& part, const PartOrigins& origins,
                         std::span<const Polygon> of_file);

}  // namespace talweg
