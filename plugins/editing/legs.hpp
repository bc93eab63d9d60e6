// Legs are the stretches of a curve between the points that it was drawn through.
#pragma once

#include <cstddef>
#include <vector>

#include "vectors.hpp"

namespace talweg::editing {

/// Before which of the given points a new one belongs that was picked on a line: between the line's
/// points `segment` and `segment + 1`. The line passes by the given points in their order; at the
/// end of a closed one that is after the last. Throws Error without two given points and a segment.
/// O(given points x points of the line).
std::size_t leg_at(const std::vector<Vector>& given, const std::vector<Vector>& line, bool closed,
                   std::size_t segment);

}  // namespace talweg::editing
