// Level crossings are where a line over the surface passes from near a curve to far from it.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/convex_stretch.hpp"

namespace talweg {

/// The places on a line of some length where a stretch begins or ends, in order. Whether the ends
/// of the line are near was decided for all lines that meet there; where the stretches disagree, by
/// rounding, the line crosses at its very end. So there is an odd number of crossings if and only
/// if one end is near and the other is not.
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
