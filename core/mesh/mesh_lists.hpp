// Mesh lists are a mesh as a file or a caller gives it: nothing is checked, nothing dropped.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Vertex and face numbers here are the numbers of all results. Polygons are fan-triangulated when
/// a file is read: the triangles of one polygon follow each other.
struct MeshLists {
  std::vector<Point> points;        ///< mesh units
  std::vector<Triangle> triangles;  ///< counterclockwise, indices of points
  std::size_t polygon_count = 0;    ///< faces of the file that had more than three corners
  bool single_precision = false;    ///< the file stores its coordinates as 32-bit floats
  std::vector<std::string> notes;   ///< sentences: what a file has that was read otherwise or not
};

}  // namespace talweg
