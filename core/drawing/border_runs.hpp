// Border runs are the parts of a stroke that lie beyond the border of an open mesh.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/point.hpp"

namespace talweg {

/// The part of a stroke beyond the border at one of the stroke's ends.
struct BorderRun {
  std::size_t samples = 0;       ///< beyond the border; 0: the stroke does not leave
  double farthest = 0;           ///< mesh units: their largest distance from the mesh
  Point leaves = Point::Zero();  ///< where, between two samples, the stroke leaves
};

/// The runs at the start and at the end of an open stroke. A sample lies beyond the border if its
/// nearest point on the mesh lies on the border and is more than a rounding (1e-4 mean edges) away.
/// A stroke leaves the mesh if its distance from the mesh reaches at least a quarter of its length
/// along the border (14 degrees). A stroke that was drawn along the border has no run, and neither
/// has a stroke that is nowhere on the mesh. O(log faces) for each sample of a run.
std::array<BorderRun, 2> border_runs(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                     std::span<const Point> samples);

}  // namespace talweg
