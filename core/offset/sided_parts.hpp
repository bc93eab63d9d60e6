// Sided parts are the stretches of an isoline that lie on a wanted side of the curves.
#pragma once

#include <vector>

#include "talweg/core/offset/distance_isoline.hpp"
#include "talweg/core/offset/offset_curves.hpp"
#include "talweg/core/offset/way_origin.hpp"

namespace talweg {

/// A part of an isoline. On the left or the right of a curve, the part runs in the direction of the
/// curve; elsewhere the nearer side is on its left.
struct SidedPart {
  SurfaceCurve curve;
  CurveSide side = CurveSide::kBoth;  ///< both: around a curve, or along both of its sides
  std::size_t along = 0;              ///< number of the curve nearest to the first point
  double arc = 0;                     ///< arc length on `along`; a closed part begins at its least
};

/// Cuts an isoline into the parts on a wanted side. A point of unknown side has the side of the
/// last point before it with a known side. A part ends where the side changes; the place is found
/// by bisection of the segment. O(points · ways into a face).
std::vector<SidedPart> sided_parts(const Surface& surface, const LevelCurve& isoline,
                                   const WayOrigins& origins, CurveSide side, OffsetCaps caps);

}  // namespace talweg
