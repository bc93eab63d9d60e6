// A curve input is a curve as a file or a host gives it.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// It has not been checked against a mesh; snap() does that.
struct CurveInput {
  bool closed = false;  ///< the first point is then not repeated
  /// Vertices of the mesh, points in its faces, or positions in space.
  std::variant<std::vector<VertexId>, std::vector<FaceCoordinates>, std::vector<Point>> points;
  std::vector<std::size_t> pins;  ///< indices of points that must stay, ascending
};

}  // namespace talweg
