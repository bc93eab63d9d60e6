// Finds the part of a curve at a place.
#pragma once

#include <array>
#include <vector>

namespace talweg::paraview {

/// The index k such that the curve passes the place between the points k and k + 1 of `joined`,
/// within a distance; -1 if the curve does not pass it.
int segment_at(const std::vector<std::array<double, 3>>& curve, bool closed,
               const std::vector<std::array<double, 3>>& joined, const std::array<double, 3>& place,
               double within);

}  // namespace talweg::paraview
