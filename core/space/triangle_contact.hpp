// Triangle contacts are where two triangles in space meet.
#pragma once

#include <array>

#include "talweg/core/space/point.hpp"

namespace talweg {

using PointTriangle = std::array<Point, 3>;

/// Whether two triangles have nothing in common but corners at the same places, and the side
/// between two of these. Only where rounding leaves no doubt, so false is said of some that almost
/// touch, or almost fold onto each other; of triangles without a width, too.
bool certainly_apart(const PointTriangle& s, const PointTriangle& t);

/// How far the segment from p to q goes through a triangle, measured by how little it would have to
/// move to be free: the least distance of its ends from the plane and of the place where it pierces
/// from the sides. 0 where it does not.
double piercing_depth(const Point& p, const Point& q, const PointTriangle& t);

/// The largest piercing_depth() of a side of one in the other.
double crossing_depth(const PointTriangle& s, const PointTriangle& t);

/// The same by the farther end of the side: how much of it is there, not how little it would take.
double crossing_reach(const PointTriangle& s, const PointTriangle& t);

}  // namespace talweg
