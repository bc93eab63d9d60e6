// Sided parts are those stretches of an isoline that lie on a wanted side of the curves.
#pragma once

#include <vector>

#include "talweg/core/offset/distance_isoline.hpp"
#include "talweg/core/offset/offset_curves.hpp"
#include "talweg/core/offset/way_origin.hpp"

namespace talweg {

/// A part of an isoline. On the left or the right of a curve it runs along with it; elsewhere what
/// is nearer is on its left.
struct SidedPart {
  SurfaceCurve curve;
  CurveSide side = CurveSide::kBoth;  ///< both: around a curve, or along both of its sides
  std::size_t along = 0;              ///< number of the curve that its first point is nearest to
  double arc = 0;                     ///< arc length there; a closed part begins where it is least
};

/// Points whose side is not known have that of the point before them that is beside a curve. A part
/// ends where the side changes, which is found by halving the last segment. O(points · ways into a
/// face).
std::vector<SidedPart> sided_parts(const Surface& surface, const LevelCurve& isoline,
                                   const WayOrigins& origins, CurveSide side, OffsetCaps caps);

}  // namespace talweg
