// A snapped drawing is curves that were put on a mesh and joined there, and what that did to them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/drawing/way_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct SnappedDrawing {
  std::vector<SurfaceCurve> curves;
  std::vector<bool> may_be_loop;  ///< per curve, see SnappedCurve; or none
  /// Per curve how far apart in space the samples of a hand are at its start and at its end, the
  /// largest of three steps, mesh units; 0 for what is no open stroke of a hand. Or none.
  std::vector<std::array<double, 2>> hand_steps;
  std::vector<SurfacePoint> pins;
  std::vector<WayPoint> way_points;   ///< that the drawing names
  std::vector<WayPoint> all_exact;    ///< instead, if a curve that names none has all its points
  std::vector<SurfacePoint> painted;  ///< that the drawing names
  std::vector<std::string> strokes;   ///< sentences on control points that are no way-points
  std::vector<std::string> told;      ///< sentences on points that were put elsewhere
  double largest_snap_distance = 0;   ///< largest move of a position onto the mesh, mesh units
  std::string better_fit;             ///< of the first curve that has one, see SnappedCurve
  std::string moved;                  ///< sentences about that; empty if nothing was moved
  /// Whether these must come first: it was moved far, or would fit better elsewhere.
  bool far = false;
  JoinedGaps gaps;
  JoinedGaps gaps_in_strokes;  ///< those of curves without way-points, between which a leg is meant

  /// Adds curves whose points are joined straight over the surface. Throws as
  /// StraightLines::join(). O(points log points), and the lines over gaps.
  void add(const SurfaceMesh& mesh, std::span<const SnappedCurve> snapped, StraightLines& lines,
           const Progress& progress = {});
  /// Warnings for the user: that the drawing was moved onto the mesh, and that gaps were joined.
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// Those of them by which a result may be of no use: moved far, or gaps joined in a stroke.
  [[nodiscard]] std::vector<std::string> decisive() const;
  /// Adds warnings to `all`: at the front if the drawing was moved far, otherwise at the end.
  void add_to(std::vector<std::string>& all, const std::vector<std::string>& warnings) const {
    all.insert(far ? all.begin() : all.end(), warnings.begin(), warnings.end());
  }
};

}  // namespace talweg
