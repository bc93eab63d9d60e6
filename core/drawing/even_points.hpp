// Even points resample a curve with equal steps along its length.
#pragma once

#include <cstddef>
#include <optional>

#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Either the number of points or their distance.
struct EvenPoints {
  std::optional<std::size_t> count;  ///< at least 2; for a closed curve at least 3
  double spacing = 0;                ///< mesh units, > 0; rounded so that the steps are equal
};

struct ResampledCurve {
  PlacedCurve curve;   ///< successive points need not share a face; without marks
  double spacing = 0;  ///< mesh units: the step, measured along the given curve
};

/// The largest number of points of a resampled curve.
constexpr std::size_t kMostEvenPoints = 10'000'000;

/// Points on a curve at equal steps of its length on the surface. An open curve keeps its two ends;
/// a closed one keeps its first point, which is not repeated. The points lie in the curve's own
/// faces, so they are on the surface but for rounding.
/// Throws Error(kBadUsage) for fewer points than 2 (closed: 3) or more than kMostEvenPoints, and
/// for a spacing that is not above 0; Error(kBadCurve) where two neighbours of the curve share no
/// face. O(points of both).
ResampledCurve resampled(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                         const EvenPoints& even);

}  // namespace talweg
