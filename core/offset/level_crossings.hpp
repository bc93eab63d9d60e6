// Level crossings are the places where a line on the surface passes between near a curve and far
// from it.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/convex_stretch.hpp"

namespace talweg {

/// The places on a line of the given length where a stretch near the curve begins or ends, in
/// order. `begins_near` and `ends_near` tell whether the ends of the line are near; all lines that
/// meet at an end must have the same value there. If the stretches disagree with these values, by
/// rounding, a crossing is put at the very end of the line. The number of crossings is therefore
/// odd if and only if one end is near and the other is far.
inline std::vector<double> level_crossings(std::span<const Stretch> near, double length,
                                           bool begins_near, bool ends_near) {
  std::vector<double> at;
  for (const Stretch& s : near) {
    at.push_back(s.from);
    at.push_back(s.to);
  }
  if (begins_near && !at.empty() && at.front() <= 0) {
    at.erase(at.begin());
  } else if (begins_near) {
    at.insert(at.begin(), 0.0);
  }
  if (ends_near && !at.empty() && at.back() >= length) {
    at.pop_back();
  } else if (ends_near) {
    at.push_back(length);
  }
  return at;
}

}  // namespace talweg
