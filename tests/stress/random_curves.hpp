// Random curves of every kind that a file or a host can give.
#pragma once

#include <string>
#include <vector>

#include "stress/random.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::stress {

struct RandomDrawing {
  std::string kind;
  std::vector<CurveInput> curves;
  bool connect = false;  ///< whether vertex ids are joined by straight lines
};

/// Open or closed curves along edges, through faces, from positions on and off the surface, along
/// and touching boundaries; with repeats, spikes and reversed pieces; of one point or many; one
/// curve or several.
RandomDrawing random_drawing(const SurfaceMesh& mesh, Random& random);

}  // namespace talweg::stress
