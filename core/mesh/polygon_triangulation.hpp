// Polygon triangulation replaces the fans that readers make of polygons where a fan leaves its
// polygon.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// triangulate_polygons() of mesh_lists.hpp that also rearranges the attributes at corners.
void triangulate_polygons(MeshLists& lists, MeshAttributes* attributes);

/// The corners around the triangles of one polygon, from the first corner of the first triangle.
/// Empty if the triangles do not form a disc whose boundary visits each of their vertices once.
/// O(triangles log triangles).
std::vector<PolygonCorner> outline(const std::vector<Triangle>& all,
                                   std::span<const std::uint32_t> triangles);

}  // namespace talweg
