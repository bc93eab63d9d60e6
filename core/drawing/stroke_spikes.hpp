// Spikes are samples of a stroke that a tracker put far from the hand.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// The samples, ascending, at which a stroke jumps away and comes back: up to three in a row, more
/// than eight usual steps away from the samples before and after them, which themselves lie within
/// four usual steps of each other. Steps no longer than the usual step make a quarter of the
/// stroke's length. Samples with coordinates that are not finite are never spikes. O(n log n).
std::vector<std::size_t> spikes_of(std::span<const Point> samples, bool closed);

}  // namespace talweg
