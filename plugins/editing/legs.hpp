// Legs are the stretches of a curve between the points through which it was drawn.
#pragma once

#include <cstddef>
#include <vector>

#include "vectors.hpp"

namespace talweg::editing {

/// The index at which a new point is to be inserted into the given points. The new point was picked
/// on the drawn line, between the line's points `segment` and `segment + 1`. The line passes the
/// given points in their order. On the last leg of a closed line, the index is the number of given
/// points. Throws Error for fewer than two given points, or if the line has no such segment.
/// O(given points x points of the line).
std::size_t leg_at(const std::vector<Vector>& given, const std::vector<Vector>& line, bool closed,
                   std::size_t segment);

}  // namespace talweg::editing
