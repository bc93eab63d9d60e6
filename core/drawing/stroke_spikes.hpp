// Spikes of a stroke are samples that a tracker put somewhere else.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// The samples, ascending, at which a stroke jumps away and comes back: up to three in a row, more
/// than eight times the usual step away from the samples before and after them, while these lie
/// within four usual steps of each other. A usual step is one that a quarter of the stroke's length
/// is made of shorter ones, or equal ones. Samples that are not finite are none. O(n log n).
std::vector<std::size_t> spikes_of(std::span<const Point> samples, bool closed);

}  // namespace talweg
