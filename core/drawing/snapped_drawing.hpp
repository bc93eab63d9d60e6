// A snapped drawing has the curves that were put on a mesh and joined there, and their warnings.
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
  std::vector<bool> may_be_loop;  ///< per curve, see SnappedCurve; may be empty
  /// Per curve the distance in space of the hand's samples at the start and at the end: the largest
  /// of three steps, mesh units; 0 for a curve that is not an open stroke of a hand. May be empty.
  std::vector<std::array<double, 2>> hand_steps;
  std::vector<SurfacePoint> pins;
  std::vector<WayPoint> way_points;   ///< named by the drawing
  std::vector<WayPoint> all_exact;    ///< the way-points under PointMeaning::kExact
  std::vector<SurfacePoint> painted;  ///< named by the drawing
  std::vector<std::string> strokes;   ///< sentences on control points that are not way-points
  std::vector<std::string> notes;     ///< sentences on points that were moved or left out
  double largest_snap_distance = 0;   ///< largest move of a position onto the mesh, mesh units
  std::string better_fit;             ///< from the first curve that has a text, see SnappedCurve
  std::string moved;                  ///< sentences on moves onto the mesh; may be empty
  /// Whether `moved` must come first: the drawing was moved far, or would fit better elsewhere.
  bool far = false;
  JoinedGaps gaps;
  JoinedGaps gaps_in_strokes;  ///< only in curves without way-points

  /// Adds curves whose points are joined straight over the surface. Throws as
  /// StraightLines::join(). O(points log points), and the lines over gaps.
  void add(const SurfaceMesh& mesh, std::span<const SnappedCurve> snapped, StraightLines& lines,
           const Progress& progress = {});
  /// Warnings for the user: that the drawing was moved onto the mesh, and that gaps were joined.
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// Warnings of such weight that the result may be useless: the drawing was moved far, or gaps
  /// were joined in a stroke.
  [[nodiscard]] std::vector<std::string> decisive() const;
  /// Adds warnings to `all`: at the front if the drawing was moved far, otherwise at the end.
  void add_to(std::vector<std::string>& all, const std::vector<std::string>& warnings) const {
    all.insert(far ? all.begin() : all.end(), warnings.begin(), warnings.end());
  }
};

}  // namespace talweg
