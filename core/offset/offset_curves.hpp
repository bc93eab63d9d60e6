// Offset curves run at a given distance along the surface from other curves.
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

/// A side of a curve, seen along the curve from outside the mesh.
enum class CurveSide { kBoth, kLeft, kRight };
const char* to_string(CurveSide side);  ///< "both", "left", "right"

/// The course of an offset at the ends of open curves.
enum class OffsetCaps {
  kRound,  ///< around the ends
  kNone,   ///< cut off where the shortest way to the curve leads to an end
};

struct OffsetOptions {
  std::vector<double> distances;      ///< mesh units, > 0, at least one
  CurveSide side = CurveSide::kBoth;  ///< an offset on one side has no caps
  OffsetCaps caps = OffsetCaps::kRound;
  /// Mesh units, > 0: largest error of the distance between two points of a result. Default: a
  /// thousandth of the distance or a fiftieth of the mean edge length, whichever is less. An eighth
  /// of the distance is used if the tolerance is larger.
  std::optional<double> tolerance;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// One component of an offset.
struct OffsetCurve {
  SurfaceCurve curve;
  double distance = 0;  ///< mesh units: an element of OffsetOptions::distances
  /// The side of the curve `along` on which the offset lies; kBoth if the offset goes around the
  /// curve. On the left and the right the offset runs in the direction of the curve; an offset
  /// around a curve has the nearer side on its left.
  CurveSide side = CurveSide::kBoth;
  std::size_t along = 0;  ///< number of the curve nearest to the first point
  double length = 0;      ///< mesh units
  /// Mesh units: largest difference to `distance` at the points and the midpoints between them.
  double off_max = 0;
};

struct OffsetResult {
  std::vector<OffsetCurve> curves;    ///< by distance as given, then curve, side, and arc length
  std::vector<std::string> warnings;  ///< the reason for each distance without a curve
};

/// Finds all points of the surface whose distance to the nearest curve is one of the distances, as
/// curves. The distance is exact (PolylineDistance): at the points of the offsets up to a relative
/// error of 1e-9, between them within the tolerance. An offset may have a corner where the nearest
/// point of a curve changes. An offset is closed, or ends on the boundary of the mesh, or is cut
/// off at the limit of a side or cap. Bands narrower than half the tolerance may be missed. A curve
/// of one point has a circle around it. Only the surface nearer than the largest distance is
/// visited; memory is O(mesh). Throws Error(kBadUsage) as OffsetOptions::validate(),
/// Error(kBadCurve) if there is no curve, a curve has no points, or two neighbouring points share
/// no face; Cancelled when `progress` (stage "offset") says so.
OffsetResult offset_curves(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                           const OffsetOptions& options, const Progress& progress = {});

}  // namespace talweg
