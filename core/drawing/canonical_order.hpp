// The canonical order makes one curve of those that are drawn the other way or begun elsewhere.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// In which order a curve's points are gone through, whoever drew them: point k of the ordered
/// curve is point start + k of the drawn one, or start - k if reversed.
struct CurveOrder {
  std::size_t start = 0;
  bool reversed = false;

  [[nodiscard]] std::size_t drawn_index(std::size_t k, std::size_t points) const {
    return reversed ? (start + points - k % points) % points : (start + k) % points;
  }
};

/// The order in which the sequence of the segments' lengths (in billionths of the whole, so that
/// rounding does not decide) is the smallest: of both directions of an open curve, of all starts in
/// both directions of a closed one. Of orders that are equal in this, that with the least sequence
/// of turns (nanoradians, to the left), and of those that with the least sequence of positions, so
/// that also on regular grids only one is left; as drawn where all three are equal. The same for a
/// curve that is reversed or begun elsewhere, or on a renumbered mesh; moved or scaled too unless
/// positions decide. O(points), O(points log points) where lengths do not decide. Throws
/// Error(kBadCurve) as curve_length() does.
CurveOrder canonical_order(const SurfaceMesh& mesh, const SurfaceCurve& curve);

/// The curve in this order.
SurfaceCurve in_order(const SurfaceCurve& curve, const CurveOrder& order);

/// In which order the curves of a set are gone through, whoever listed them: open ones first, then
/// by number of points, share of the set's length (in billionths), and positions. For curves that
/// are in_order(). O(points + curves log).
std::vector<std::size_t> canonical_set_order(const SurfaceMesh& mesh,
                                             const std::vector<SurfaceCurve>& ordered);

}  // namespace talweg
