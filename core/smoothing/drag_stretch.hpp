// A drag stretch is the part of a changed drawing that is smoothed again, with the curves and
// valleys near it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct DragStretch {
  SurfaceCurve curve;
  std::vector<SurfaceCurve> near;         ///< the curves that the distance is set to
  std::vector<Corridor::Valley> valleys;  ///< one per curve of `near`
};

/// The points [first, last) of curve `number`, and the runs of all curves within `reach` (mesh
/// units) of the bounding box of these points; runs of curve `number` come first. A curve entirely
/// in the box is one run, and stays closed. `valleys` are the valleys of the whole curves; slack_at
/// has one value per point. O(points).
DragStretch stretch_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                       const std::vector<Corridor::Valley>& valleys, std::size_t number,
                       std::size_t first, std::size_t last, double reach);

}  // namespace talweg
