// A way-point is a point of a drawing that is meant exactly, as a click is.
#pragma once

#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct WayPoint {
  SurfacePoint point;
  double tolerance = 0;  ///< mesh units, >= 0: how far from it the result may pass

  bool operator==(const WayPoint&) const = default;
};

}  // namespace talweg
