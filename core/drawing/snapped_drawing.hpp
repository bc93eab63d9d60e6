// A snapped drawing is curves that were put on a mesh and joined there, and what that did to them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct SnappedDrawing {
  std::vector<SurfaceCurve> curves;
  std::vector<SurfacePoint> pins;
  double largest_snap_distance = 0;  ///< by which a position was moved onto the mesh, mesh units
  std::string moved;                 ///< a sentence on that, if any was
  bool far = false;                  ///< so far that the sentence comes before everything else
  JoinedGaps gaps;

  /// Adds curves, their points joined straight over the surface. Throws as StraightLines::join().
  void add(const SurfaceMesh& mesh, std::span<const SnappedCurve> snapped, StraightLines& lines,
           const Progress& progress = {});
  /// What a user should know: that it was moved onto the mesh, and that gaps were joined.
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// Adds warnings to others: in front where the drawing was moved far.
  void add_to(std::vector<std::string>& all, const std::vector<std::string>& warnings) const {
    all.insert(far ? all.begin() : all.end(), warnings.begin(), warnings.end());
  }
};

}  // namespace talweg
