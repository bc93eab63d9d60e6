// An even stroke has its places at one distance from each other, however it was sampled.
#pragma once

#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct EvenStroke {
  bool closed = false;
  double step = 0;                ///< mesh units, through space
  std::vector<Point> at, normal;  ///< per place, and the unit normal of its face

  /// What is left of the stroke's length when it is walked in these steps.
  [[nodiscard]] double length() const { return step * static_cast<double>(at.size()); }
};

/// The stroke walked with a compass (compass_walk.hpp) in steps that are worth it, see
/// walkable_step(). O(points · degree + places).
EvenStroke even_stroke(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double step);

}  // namespace talweg
