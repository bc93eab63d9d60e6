// The contact of two triangles in space: whether they are apart, and how deep they cross.
#pragma once

#include <array>

#include "talweg/core/space/point.hpp"

namespace talweg {

using PointTriangle = std::array<Point, 3>;

/// Whether two triangles have nothing in common but corners at equal positions and the side between
/// two of these. True only if rounding leaves no doubt: false for some triangles that almost touch
/// or almost fold onto each other, and for some triangles without a width.
bool certainly_apart(const PointTriangle& s, const PointTriangle& t);

/// The depth to which the segment from p to q pierces a triangle: the smallest move that would free
/// the segment. The depth is the least distance of the ends from the plane and of the piercing
/// point from the sides. 0 if the segment does not pierce the triangle.
double piercing_depth(const Point& p, const Point& q, const PointTriangle& t);

/// The largest piercing_depth() of a side of one triangle in the other.
double crossing_depth(const PointTriangle& s, const PointTriangle& t);

/// Like crossing_depth(), but with the farther end of the side in place of the nearer end. The
/// result is the length by which the triangles extend beyond each other, rather than the smallest
/// move that would free them.
double crossing_reach(const PointTriangle& s, const PointTriangle& t);

}  // namespace talweg
