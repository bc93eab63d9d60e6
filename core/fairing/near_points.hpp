// Points of a curve that hardly differ from the one before or behind them.
#pragma once

#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct KeptPoint {
  SurfacePoint point;
  double arc = 0;      ///< how far along the curve, mesh units
  bool stays = false;  ///< whatever is near
};

/// Drops points that are nearer than `near` (mesh units) to a neighbour along the curve of
/// `length`, where their neighbours share a face: on so short a way rounding makes a turn of any
/// size. Of several that are near each other one at a vertex is kept. O(points).
void drop_near_points(const Surface& surface, bool closed, double length, double near,
                      std::vector<KeptPoint>& points);

}  // namespace talweg
