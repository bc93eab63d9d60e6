// Joined lines are made of lines between numbered points that meet end to end.
#pragma once

#include <cstdint>
#include <vector>

namespace talweg {

/// Indices into a list of points.
using Line = std::vector<std::uint32_t>;

/// Joins lines that meet end to end where exactly two line ends meet; junctions stay ends. A curve
/// has the direction and the position in the list of its first line. Of two-point lines that repeat
/// an earlier one (in either direction) only the first is kept. O(n log n).
std::vector<Line> joined(std::vector<Line> lines);

}  // namespace talweg
