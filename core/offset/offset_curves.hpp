// Offset curves run at a distance along the surface from other curves.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// On which side of a curve something lies, seen along the curve from outside the mesh.
enum class CurveSide { kBoth, kLeft, kRight };
const char* to_string(CurveSide side);  ///< "both", "left", "right"

/// What an offset does at the ends of open curves.
enum class OffsetCaps {
  kRound,  ///< it goes around them
  kNone,   ///< it is cut off where the way to the curve leads to its end
};

struct OffsetOptions {
  std::vector<double> distances;      ///< mesh units, > 0, at least one
  CurveSide side = CurveSide::kBoth;  ///< on one side there are never caps
  OffsetCaps caps = OffsetCaps::kRound;
  /// Mesh units, > 0: how far the distance may be off between two points of a result. By default a
  /// thousandth of the distance or a fiftieth of the mean edge, whichever is less.
  std::optional<double> tolerance;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// One component of an offset.
struct OffsetCurve {
  SurfaceCurve curve;
  double distance = 0;  ///< mesh units: the one of the options that it belongs to
  /// Of the curve that it lies along; both where it goes around it. On the left and the right it
  /// runs in the curve's direction; around it what is nearer is on its left.
  CurveSide side = CurveSide::kBoth;
  std::size_t along = 0;  ///< number of that curve, the nearest to its first point
  double length = 0;      ///< mesh units
  /// Mesh units: the largest difference to `distance` at its points and the middles between them.
  double off_max = 0;
};

struct OffsetResult {
  std::vector<OffsetCurve> curves;    ///< by distance as given, then curve, side, and place along
  std::vector<std::string> warnings;  ///< a sentence for each distance without a curve, and why
};

/// All points of the surface whose shortest way to any of the curves has one of the distances, as
/// curves. The distance is exact (PolylineDistance) at their points up to 1e-9 of it, and within
/// the tolerance between them. Where the nearest point of a curve changes they may have a corner.
/// They are closed, or end on the boundary of the mesh, or where one side or caps are cut off.
/// Bands that are narrower than half the tolerance may be missed. A curve of one point has a circle
/// around it. Only what is nearer than the largest distance is visited; memory is O(mesh). Throws
/// Error(kBadUsage) as OffsetOptions::validate(), Error(kBadCurve) where there is no curve, one has
/// no points, or two neighbours share no face; Cancelled when `progress` (stage "offset") says so.
OffsetResult offset_curves(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                           const OffsetOptions& options, const Progress& progress = {});

}  // namespace talweg
