// Border runs are the parts of a stroke that lie beyond the border of an open mesh.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/point.hpp"

namespace talweg {

/// What a stroke does at one of its ends.
struct BorderRun {
  std::size_t samples = 0;       ///< how many there lie beyond the border; 0: it does not leave
  double farthest = 0;           ///< mesh units: of these from the mesh
  Point leaves = Point::Zero();  ///< the place between two samples where the stroke leaves
};

/// The runs at the start and at the end of an open stroke. A sample lies beyond the border if what
/// is nearest to it on the mesh lies there, more than a rounding (1e-4 mean edges) away. A stroke
/// leaves if it gets at least a quarter as far from the mesh as it goes along the border (14
/// degrees); one that was drawn along the border has no run, nor has one that is nowhere on the
/// mesh. O(log faces) for each sample of a run.
std::array<BorderRun, 2> border_runs(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                     std::span<const Point> samples);

}  // namespace talweg
