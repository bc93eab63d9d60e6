// Welding finds which vertices of raw lists are one and the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct Welding {
  std::vector<std::uint32_t> onto;  ///< per vertex the smallest one of its group
  double tolerance = 0;             ///< mesh units: the given one, and the rounding
  std::size_t held_apart = 0;       ///< vertices that a given tolerance would have joined to others
};

/// Groups vertices of faces that lie at the same position, or close together: within two units in
/// the last place of the mesh's largest coordinate (of 32-bit floats where the file stores those)
/// and within a quarter of the shortest edge of positive length at either vertex. The second bound
/// keeps neighbours on a coarsely rounded mesh apart. Vertices in no face stay alone. Every index
/// must be in range and every coordinate finite. O(vertices log vertices).
///
/// With `tolerance` > 0 (mesh units) vertices within it, and that rounding, are joined, if they are
/// also within half of the shortest edge at either vertex; so are those that others join. A group
/// that would have both ends of an edge stays apart, except for what lies at the same position. The
/// groups do not depend on the order of vertices and faces.
Welding weld_vertices(const MeshLists& lists, double tolerance = 0);

/// Vertices that nearly coincide with others, but have no edge to them.
struct NearVertices {
  double within = 0;       ///< mesh units: up to here others were looked for
  std::size_t count = 0;   ///< vertices with another one that near, at another position
  double largest_gap = 0;  ///< mesh units: from one of them to the one it would be welded onto
  double tolerance = 0;    ///< mesh units, two digits: welding with it joins them; 0 without any
};

/// The vertices that weld_vertices() would join within 1e-4 of the mesh's mean edge length, or four
/// units in the last place of its largest coordinate if that is more. None where indices are out of
/// range or coordinates not finite. O(vertices log vertices).
NearVertices near_vertices(const MeshLists& lists, const MeshInspection& inspection);

}  // namespace talweg
