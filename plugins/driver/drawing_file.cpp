#include "drawing_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "talweg/core/formats/curve_file.hpp"
#include "talweg/core/snapping.hpp"
#include "talweg/core/straight_lines.hpp"

namespace talweg::driver {

Drawing read_drawing(const std::string& path, const SurfaceMesh& mesh) {
  Drawing drawing;
  StraightLines lines(mesh.surface());
  for (const SnappedCurve& snapped : snap(mesh, read_curves(path))) {
    for (const std::size_t pin : snapped.pins) drawing.pins.push_back(snapped.points[pin]);
    drawing.curves.push_back(lines.join(snapped.points, snapped.closed));
    drawing.largest_snap_distance =
        std::max(drawing.largest_snap_distance, snapped.largest_snap_distance);
  }
  return drawing;
}

std::vector<std::string> reading_warnings(double largest_snap_distance, std::size_t polygons) {
  std::vector<std::string> warnings;
  if (largest_snap_distance > 0) {
    warnings.push_back(fmt::format("The curve was moved onto the mesh, by up to {:.3g} mesh units.",
                                   largest_snap_distance));
  }
  if (polygons > 0) {
    warnings.push_back(std::to_string(polygons) +
                       " polygons of the mesh were split into triangles.");
  }
  return warnings;
}

}  // namespace talweg::driver
