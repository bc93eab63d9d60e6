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

/// The step, or the least one that is worth to be walked if that is longer: places between samples
/// of the polyline say nothing new, so there are at most 4096 and 16 for each point.
double walkable_step(std::span<const Point> points, bool closed, double step);

/// The places of a walk: it begins at the first point, and each place is where the polyline first
/// leaves the ball of radius `step` > 0 about the one before. So the walk does not see how the
/// polyline was sampled: what rests within a step, or trembles there, is passed over. With
/// `rejoining` it is where the polyline leaves that ball for the last time before it leaves the one
/// of twice the radius: small loops and ways back are passed over, too. An open polyline's last
/// point is a place, and none lies nearer to it than half a step. A closed one goes on to the first
/// point, which is not repeated. O(points + places); rejoining, each step looks again at what lies
/// within two of them.
std::vector<PolylinePlace> compass_walk(std::span<const Point> points, bool closed, double step,
                                        bool rejoining = false);

}  // namespace talweg
