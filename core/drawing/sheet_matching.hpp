// Sheet matching puts all points of a polyline on the same side of a thin wall.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

struct SheetMatching {
  std::vector<ClosestPoint::Result> points;  ///< one per position
  std::size_t moved = 0;                     ///< points that were not put on their nearest sheet
  std::size_t first_moved = 0;               ///< the index of the first of them, if any
  /// Pairs of successive points without a path over the surface about as short as the way through
  /// space, and the first of these pairs, if any.
  std::size_t jumps = 0;
  std::size_t first_jump = 0;
};

/// Positions beside a thin wall may be nearer to its far side when each is projected alone. The
/// polyline is therefore matched to the surface as a whole, as GPS tracks are matched to roads
/// (Newson & Krumm 2009). Each position has a candidate on each sheet near it. The chosen
/// candidates have the least sum of distances and of costs of jumps. A step is a jump if no path
/// over the faces joins its ends inside a ball about both; a jump costs four mean edges and twice
/// its length. A step to another component of the mesh, which no path reaches, costs more than all
/// others together. Steps over more than 16 mean edges are no jumps. `nearest` has the nearest
/// points, one per position; they are the answer if no step between them is a jump. O(faces near
/// the polyline), and O(mesh) if there is a jump.
SheetMatching matched_to_sheets(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                std::span<const Point> positions, bool closed,
                                std::vector<ClosestPoint::Result> nearest);

}  // namespace talweg
