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
  SurfacePoint at;       ///< where it begins on the first curve that passes there
  std::size_t curve;     ///< that curve
  bool stretch = false;  ///< whether a piece of positive length is passed more than once
};

/// The connected parts of the set of points that the curves pass more than once, each counted
/// once: a crossing, a common point, a common stretch with all that meets it. In the order of the
/// curves. A curve that turns back along itself has a stretch there; where a segment and the next
/// meet is no contact.
///
/// Points within 1e-9 of their face's longest side of each other are one; loops shorter than 1e-6
/// of it are not seen. O(n log n) for n points that are not all at one place.
/// Throws Error(kBadCurve) when a curve has no points or two neighbours share no face.
std::vector<SelfContact> self_contacts(const Surface& surface,
                                       std::span<const SurfaceCurve> curves);

}  // namespace talweg
