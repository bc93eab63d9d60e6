// A screen line is a curve projected to the screen; the mouse picks one of its segments.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace talweg::editing {

/// A place on the screen, pixels.
using Pixel = std::array<double, 2>;

inline double distance(const Pixel& a, const Pixel& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

struct NearSegment {
  double away = std::numeric_limits<double>::infinity();  ///< distance to the segment, pixels
  std::size_t segment = 0;  ///< the index of the segment's first point
  double along = 0;         ///< the place of the nearest point along the segment, from 0 to 1
};

/// The segment of a line that is nearest to a place. The distance is infinite if the line has no
/// segment.
inline NearSegment nearest_segment(const std::vector<Pixel>& line, bool closed, const Pixel& at) {
  NearSegment nearest;
  for (std::size_t k = 0; k + 1 < line.size() + (closed ? 1 : 0); ++k) {
    const Pixel &from = line[k], &to = line[(k + 1) % line.size()];
    const Pixel way = {to[0] - from[0], to[1] - from[1]};
    const double square = way[0] * way[0] + way[1] * way[1];
    const double dot = (at[0] - from[0]) * way[0] + (at[1] - from[1]) * way[1];
    const double along = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
    const double away = distance(at, {from[0] + along * way[0], from[1] + along * way[1]});
    if (away < nearest.away) nearest = {away, k, along};
  }
  return nearest;
}

}  // namespace talweg::editing
