// A screen line is a curve as one sees it; the mouse is near one of its segments, or not.
#pragma once

#include <QPointF>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace talweg::openflipper {

struct NearSegment {
  double away = HUGE_VAL;   ///< pixels
  std::size_t segment = 0;  ///< from the line's point of that number to the next one
};

inline double distance_to(const QPointF& a, const QPointF& b, const QPointF& at) {
  const QPointF way = b - a;
  const double square = QPointF::dotProduct(way, way);
  const double t = square > 0 ? QPointF::dotProduct(at - a, way) / square : 0;
  const QPointF off = at - a - std::clamp(t, 0.0, 1.0) * way;
  return std::hypot(off.x(), off.y());
}

/// The segment of a line, given by its points on the screen, that is nearest to a place.
inline NearSegment nearest_segment(const std::vector<QPointF>& line, bool closed,
                                   const QPointF& at) {
  NearSegment nearest;
  for (std::size_t k = 0; k + 1 < line.size() + (closed ? 1 : 0); ++k) {
    const double away = distance_to(line[k], line[(k + 1) % line.size()], at);
    if (away < nearest.away) nearest = {away, k};
  }
  return nearest;
}

}  // namespace talweg::openflipper
