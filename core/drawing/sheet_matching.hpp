// Sheet matching puts all points of a polyline on one side of a thin wall.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

struct SheetMatching {
  std::vector<ClosestPoint::Result> points;  ///< one per position
  std::size_t moved = 0;                     ///< points that were nearer to another sheet
  std::size_t first_moved = 0;               ///< the first of these, if any
  /// Pairs of successive points between which the surface has no way as short as that through
  /// space, and the first of them, if any.
  std::size_t jumps = 0;
  std::size_t first_jump = 0;
};

/// Positions beside a thin wall may be nearer to its far side, one by one. The polyline is put on
/// the surface as a whole, as GPS tracks are put on roads (Newson & Krumm 2009): of the sheets that
/// lie near each position those are taken with the least sum of distances, and of two jumps' cost
/// for each step from a point to one that cannot be reached over the faces within a ball about
/// both. Steps over more than 16 mean edges are not looked at. `nearest` has the nearest points,
/// one per position; where all steps between these can be walked they are the answer. O(faces near
/// the polyline).
SheetMatching matched_to_sheets(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                std::span<const Point> positions, bool closed,
                                std::vector<ClosestPoint::Result> nearest);

}  // namespace talweg
