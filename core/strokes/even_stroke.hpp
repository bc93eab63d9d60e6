// An even stroke has places at equal distances, whatever the sampling of the stroke.
#pragma once

#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct EvenStroke {
  bool closed = false;
  double step = 0;                ///< mesh units, through space
  std::vector<Point> at, normal;  ///< per place, and the unit normal of its face

  /// The length of the stroke as the walk in these steps measures it.
  [[nodiscard]] double length() const { return step * static_cast<double>(at.size()); }
};

/// The stroke after a compass walk (compass_walk.hpp) with the step of walkable_step(). O(points ·
/// degree + places).
EvenStroke even_stroke(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double step);

}  // namespace talweg
