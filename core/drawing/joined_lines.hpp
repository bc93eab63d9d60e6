// Joined lines are chains of lines that meet end to end.
#pragma once

#include <cstdint>
#include <vector>

namespace talweg {

/// Indices into a list of points.
using Line = std::vector<std::uint32_t>;

/// Joins lines at points where exactly two line ends meet; junctions stay ends. A chain has the
/// direction of its first line and that line's place in the list. Two-point lines that repeat an
/// earlier one, in either direction, are dropped. O(n log n).
std::vector<Line> joined(std::vector<Line> lines);

}  // namespace talweg
