// Which part of a curve is at a place.
#pragma once

#include <array>
#include <vector>

namespace talweg::paraview {

/// Between which of the points that a curve joins it passes a place, within a distance: k behind
/// the point k. -1 if it does not.
int segment_at(const std::vector<std::array<double, 3>>& curve, bool closed,
               const std::vector<std::array<double, 3>>& joined, const std::array<double, 3>& place,
               double within);

}  // namespace talweg::paraview
