// Ridge snapping moves drawings that run along a ridge or a valley onto it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/taken_points.hpp"
#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/ridges/ridge_field.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct RidgeOptions {
  /// [0, 1]. At s the surface must turn by 10° / s for a ridge to be better than the drawing; at 0
  /// nothing is moved.
  double strength = 0;
  RidgeKind kind = RidgeKind::kBoth;
  /// Mesh units, > 0: how far from what was drawn a ridge may lie. By default a fortieth of the
  /// curve's length, at least 4 and at most 12 edges of the mesh there, and at most a quarter of
  /// the curve's length; between two clicks at least a quarter of the way, and at most 40 edges.
  std::optional<double> band;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// What became of one curve.
struct RidgeMoves {
  double strength = 0;
  double band = 0;         ///< mesh units
  double scale = 0;        ///< mesh units: the radius within which turning was looked at
  double moved = 0;        ///< [0, 1]: the part of the drawing's length that left for a ridge
  double already = 0;      ///< [0, 1]: the part that lay on a ridge as it was drawn
  double farthest = 0;     ///< mesh units, between what moved and the ridge: the larger direction
  std::size_t clicks = 0;  ///< way-points that moved
  double farthest_click = 0;  ///< mesh units

  [[nodiscard]] std::string sentence(std::size_t curve) const;
};
/// For a report on one curve.
std::vector<ReportEntry> entries_of(const RidgeMoves& moves);
/// For a report on several curves; none without any.
std::vector<ReportEntry> total_entries(std::span<const RidgeMoves> moves);

struct RidgedDrawing {
  std::vector<SurfaceCurve> curves;
  TakenPoints points;             ///< between way-points everything that was moved is painted
  std::vector<RidgeMoves> moves;  ///< per curve
};

/// Each curve along ridges where those lie within the band, and as it was drawn elsewhere, to the
/// last bit. The way is the cheapest in the band (RidgeCorridor has the costs, RidgeField the
/// turning); where it leaves the drawing without a ridge under most of it, the drawing is kept.
/// Free ends and way-points move along, points of `fixed` and those that curves have in common do
/// not. Where the mesh is rough, turning is looked at in a larger radius. At strength 0 everything
/// stays. Throws Error(kBadUsage) as validate() does, Cancelled. O(vertices of the mesh) to set
/// numbers to 0 if the strength is above 0, else what lies in the bands.
RidgedDrawing snapped_to_ridges(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                std::span<const SurfacePoint> fixed, TakenPoints points,
                                const RidgeOptions& options, const Progress& progress = {});

}  // namespace talweg
