// Polygon triangulation turns the fans that readers make of polygons into triangles inside them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// triangulate_polygons() of mesh_lists.hpp; the attributes of corners follow.
void triangulate_polygons(MeshLists& lists, MeshAttributes* attributes);

/// The corners around the triangles of one polygon, from the first corner of the first triangle.
/// Empty if they are not one disc whose vertices all lie on its boundary, once each: then there is
/// no such polygon. O(triangles log triangles).
std::vector<PolygonCorner> outline(const std::vector<Triangle>& all,
                                   std::span<const std::uint32_t> triangles);

}  // namespace talweg
