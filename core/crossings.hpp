// Do curves cross?
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface.hpp"
#include "talweg/intrinsic/surface_point.hpp"

namespace talweg {

/// The curves (ascending indices) of which two segments, of the same or of different curves, cross
/// inside a face. Touching does not count. O(segments log segments), more only where many segments
/// share one face. Throws Error(kBadCurve) when a segment lies in no face.
std::vector<std::size_t> crossing_curves(const Surface& surface,
                                         std::span<const SurfaceCurve> curves);

}  // namespace talweg
