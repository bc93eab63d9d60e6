// Near points of a curve hardly differ from the previous or the next point.
#pragma once

#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct KeptPoint {
  SurfacePoint point;
  double arc = 0;      ///< arc length along the curve, mesh units
  bool stays = false;  ///< neither dropped nor moved
};

/// Drops points that are nearer than `near` (mesh units) to a neighbour along the curve of length
/// `length`, if both neighbours share a face: over so short a distance rounding can make a turn of
/// any size. Among points near each other, a point at a vertex is kept. O(points).
void drop_near_points(const Surface& surface, bool closed, double length, double near,
                      std::vector<KeptPoint>& points);

}  // namespace talweg
