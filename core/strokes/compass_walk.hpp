// A compass walk goes along a polyline in steps of one length, as dividers go along a coast.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// A place on a polyline: between a point and the next.
struct PolylinePlace {
  std::size_t segment = 0;
  double part = 0;  ///< [0, 1] of the way to the next point
  Point at = Point::Zero();
};

/// The given step, or the least useful step if that is longer. Places between the samples of a
/// polyline add no information, so a walk has at most 4096 places, and at most 16 for each point.
double walkable_step(std::span<const Point> points, bool closed, double step);

/// The places of a walk along a polyline. The walk begins at the first point, and each next place
/// is where the polyline first leaves the ball of radius `step` > 0 about the place before. So the
/// result does not depend on the sampling, and rests or trembling smaller than a step are passed
/// over. With `rejoining`, the next place is where the polyline last leaves that ball before it
/// leaves the ball of twice the radius; so small loops and ways back are passed over, too.
///
/// The last point of an open polyline is a place, and no other place lies nearer to it than half a
/// step. A closed polyline is walked on to its first point, which is not repeated. O(points +
/// places); with `rejoining`, each step visits the polyline up to two steps ahead.
std::vector<PolylinePlace> compass_walk(std::span<const Point> points, bool closed, double step,
                                        bool rejoining = false);

}  // namespace talweg
