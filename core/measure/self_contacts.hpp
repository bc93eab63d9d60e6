// Self-contacts are places where curves touch or cross themselves or each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A place that curves pass more than once.
struct SelfContact {
  SurfacePoint at;       ///< its beginning on the first curve
  std::size_t curve;     ///< the first curve with the place
  bool stretch = false;  ///< whether the place is longer than a point
};

/// The connected parts of the set of points that the curves pass more than once, each counted once:
/// a crossing, a common point, or a common stretch with all contacts connected to it. The contacts
/// are in the order of the curves. A curve that turns back along itself has a stretch there. The
/// common point of consecutive segments is not a contact.
///
/// Points closer than 1e-9 of the longest side of their face count as equal; loops shorter than
/// 1e-6 of this side are not found. O(n log n) for n points, plus the contacts inside faces. Throws
/// Error(kBadCurve) if a curve has no points or two consecutive points share no face.
std::vector<SelfContact> self_contacts(const Surface& surface,
                                       std::span<const SurfaceCurve> curves);

}  // namespace talweg
