// Self-contacts are where curves touch or cross themselves or each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A place that the curves pass more than once.
struct SelfContact {
  SurfacePoint at;       ///< where it begins on the first curve that passes it
  std::size_t curve;     ///< that curve
  bool stretch = false;  ///< whether more than a point is passed more than once
};

/// The connected parts of the set of points that the curves pass more than once, each counted once:
/// a crossing, a common point, or a common stretch with everything that meets it. They are in the
/// order of the curves. A curve that turns back along itself has a stretch there. The common point
/// of successive segments is not a contact.
///
/// Points within 1e-9 of their face's longest side of each other count as one; loops shorter than
/// 1e-6 of it are not found. O(n log n) for n points, and what meets inside faces.
/// Throws Error(kBadCurve) when a curve has no points or two neighbours share no face.
std::vector<SelfContact> self_contacts(const Surface& surface,
                                       std::span<const SurfaceCurve> curves);

}  // namespace talweg
