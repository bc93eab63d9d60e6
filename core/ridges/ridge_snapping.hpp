// Ridge snapping moves drawings onto the ridges and valleys along which they run.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/marked_points.hpp"
#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/ridges/ridge_field.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct RidgeOptions {
  /// [0, 1]. At strength s, a ridge is better than the drawing where the surface turns by more than
  /// 10° / s; at 0 nothing is moved.
  double strength = 0;
  RidgeKind kind = RidgeKind::kBoth;
  /// Mesh units, > 0: the largest distance between the drawing and a ridge. The default is a
  /// fortieth of the curve's length, at least 4 and at most 12 edges of the mesh there, and at most
  /// a quarter of the curve's length; between two clicks at least a quarter of the distance between
  /// them, and at most 40 edges.
  std::optional<double> band;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// The changes of one curve.
struct RidgeMoves {
  double strength = 0;
  double band = 0;      ///< mesh units
  double reach = 0;     ///< mesh units: the band, or less where dense clicks hold the curve
  double scale = 0;     ///< mesh units: the radius within which turning was measured
  double moved = 0;     ///< [0, 1]: the part of the drawing's length that moved onto ridges
  double already = 0;   ///< [0, 1]: the part that lay on ridges before
  double farthest = 0;  ///< mesh units, between the moved part and the ridge: the larger direction
  std::size_t clicks = 0;     ///< way-points that moved
  double farthest_click = 0;  ///< mesh units

  [[nodiscard]] std::string sentence(std::size_t curve) const;
};
/// For a report on one curve.
std::vector<ReportEntry> entries_of(const RidgeMoves& moves);
/// For a report on several curves; empty without any.
std::vector<ReportEntry> total_entries(std::span<const RidgeMoves> moves);

struct RidgedDrawing {
  std::vector<SurfaceCurve> curves;
  MarkedPoints points;            ///< moved points between way-points are painted
  std::vector<RidgeMoves> moves;  ///< per curve
};

/// Moves each curve onto ridges that lie within the band; the rest of the curve stays as drawn, to
/// the last bit. The new course is the cheapest path in the band (RidgeCorridor has the costs,
/// RidgeField the turning). A part of this path that leaves the drawing, but runs mostly beside
/// ridges, is dropped. Free ends and way-points move with the course; points of `fixed` and points
/// that curves have in common stay. On rough meshes turning is measured in a larger radius. At
/// strength 0 the drawing stays unchanged. Throws Error(kBadUsage) as validate() does, and
/// Cancelled. O(vertices within the bands); with a strength above 0, also O(vertices of the mesh)
/// to clear arrays.
RidgedDrawing snapped_to_ridges(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                std::span<const SurfacePoint> fixed, MarkedPoints points,
                                const RidgeOptions& options, const Progress& progress = {});

}  // namespace talweg
