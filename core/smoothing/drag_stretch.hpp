// A drag stretch is the part of a changed drawing that is smoothed anew, with what holds it.
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
  std::vector<SurfaceCurve> near;         ///< what the distance is measured from
  std::vector<Corridor::Valley> valleys;  ///< one for each of these
};

/// The points [first, last) of curve `number`, and those runs of all curves, its own first, that
/// come within `reach` (mesh units) of their bounding box. A curve that lies entirely in the box is
/// a single run, and stays closed if it is. `valleys` are those of the whole curves; a slack_at has
/// one value per point. O(points).
DragStretch stretch_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                       const std::vector<Corridor::Valley>& valleys, std::size_t number,
                       std::size_t first, std::size_t last, double reach);

}  // namespace talweg
