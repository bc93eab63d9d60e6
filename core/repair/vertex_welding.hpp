// Welding finds groups of vertices in raw lists that stand for the same point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct Welding {
  std::vector<std::uint32_t> onto;  ///< per vertex, the smallest vertex of its group
  double tolerance = 0;             ///< mesh units: the given tolerance plus the rounding
  std::size_t held_apart = 0;       ///< vertices within a given tolerance of others that stay apart
};

/// Groups vertices of faces at the same or nearly the same position: within two units in the last
/// place of the mesh's largest coordinate (units of 32-bit floats if the file stores floats) and
/// within a quarter of the shortest positive edge at both vertices. The second bound keeps
/// neighbours on a coarsely rounded mesh apart. Vertices without a face are not grouped. Every
/// index must be in range and every coordinate of a face finite. O(vertices log vertices).
///
/// With `tolerance` > 0 (mesh units), vertices within the tolerance plus the rounding are joined if
/// they are also within half of the shortest edge at both vertices; joining is transitive. A group
/// with both ends of an edge is divided again into its different positions. The groups do not
/// depend on the order of vertices and faces.
Welding weld_vertices(const MeshLists& lists, double tolerance = 0);

/// Vertices that nearly coincide with others to which no edge joins them.
struct NearVertices {
  double within = 0;       ///< mesh units: the radius of the search
  std::size_t count = 0;   ///< vertices with another within the radius, at another position
  double largest_gap = 0;  ///< mesh units: the largest distance of a vertex to its group's smallest
  double tolerance =
      0;  ///< mesh units, two digits: joins the vertices when given to welding; 0 if there are none
};

/// The vertices that weld_vertices() would join with a tolerance of 1e-4 times the mean edge
/// length, or four units in the last place of the largest coordinate if this is larger. None if an
/// index is out of range or a coordinate not finite. O(vertices log vertices).
NearVertices near_vertices(const MeshLists& lists, const MeshInspection& inspection);

}  // namespace talweg
