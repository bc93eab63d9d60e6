// The canonical order is the same for a curve, its reverse, and a loop that begins elsewhere.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The order in which a curve's points are processed, independent of the direction and of the first
/// point of the drawing. Point k of the ordered curve is point start + k of the drawn curve, or
/// start - k if reversed.
struct CurveOrder {
  std::size_t start = 0;
  bool reversed = false;

  [[nodiscard]] std::size_t drawn_index(std::size_t k, std::size_t points) const {
    return reversed ? (start + points - k % points) % points : (start + k) % points;
  }
};

/// The order for which the sequence of the segments' lengths (in billionths of the total length, so
/// that rounding does not decide) is lexicographically smallest. The candidates are both directions
/// of an open curve, and all starts in both directions of a closed one. Among orders with equal
/// lengths, the smallest sequence of turns (nanoradians, to the left) decides, and after it the
/// smallest sequence of positions, so that the order is unique even on regular grids. If all three
/// are equal, the curve stays as drawn. The result is the same for a curve that is reversed or
/// begun elsewhere, or on a renumbered mesh; it is also the same for a moved or scaled curve unless
/// positions decide. O(points), or O(points log points) where lengths do not decide. Throws
/// Error(kBadCurve) as curve_length() does.
CurveOrder canonical_order(const SurfaceMesh& mesh, const SurfaceCurve& curve);

/// The curve with its points in the given order.
SurfaceCurve in_order(const SurfaceCurve& curve, const CurveOrder& order);

/// Measures of a curve in the given order, converted to the drawn curve, which has `points` points.
CurveMeasures turned_back(CurveMeasures measures, const CurveOrder& order, std::size_t points);

/// The order in which the curves of a set are processed, independent of how they are listed: open
/// curves first, then by number of points, share of the set's length (in billionths), and
/// positions. The curves must be in_order(). O(points + curves log).
std::vector<std::size_t> canonical_set_order(const SurfaceMesh& mesh,
                                             const std::vector<SurfaceCurve>& ordered);

}  // namespace talweg
