// The curves of a file, put on a mesh.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/surface_mesh.hpp"
#include "talweg/intrinsic/surface_point.hpp"

namespace talweg::driver {

struct Drawing {
  std::vector<SurfaceCurve> curves;
  std::vector<SurfacePoint> pins;
  double largest_snap_distance = 0;  ///< by which a position was moved onto the mesh, mesh units
};

/// Reads curves, snaps them to the mesh and joins their points straight over the surface.
/// Throws Error as read_curves(), snap() and StraightLines::join() do.
Drawing read_drawing(const std::string& path, const SurfaceMesh& mesh);

/// What a user should know of how a curve and a mesh were read.
std::vector<std::string> reading_warnings(double largest_snap_distance, std::size_t polygons);

}  // namespace talweg::driver
