// Ear clipping cuts a polygon of the plane into triangles inside it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/plane_point.hpp"

namespace talweg {

/// The three corners of a triangle, counted along the polygon.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Twice the area of a, b, c, and how far rounding of their coordinates by `rounding` can put it
/// off.
struct TurnInPlane {
  double area = 0;
  double error = 0;
  TurnInPlane(PlanePoint a, PlanePoint b, PlanePoint c, double rounding);
  [[nodiscard]] bool left() const { return area > error; }
  [[nodiscard]] bool right() const { return area < -error; }
};

/// Triangulates a polygon that runs counterclockwise, with n >= 3 corners: n - 2 triangles, all
/// counterclockwise; flat ones only where corners lie at one place or on one line and nothing else
/// is left. The first has the corners 0 and 1 first. Corners may be named twice, as along a bridge
/// to a hole. `rounding`: of the coordinates.
///
/// Empty where there is no such triangulation: a polygon that crosses itself. (Meisters 1975,
/// "Polygons have ears"; a corner's ear changes only when a neighbour is cut off, and a tree of the
/// corners that turn inwards tells whether one lies in an ear.) The shortest cuts come first.
/// O(n log n) as a rule. It gives up,
/// with an empty result, after 1000 n steps, which the polygons tried so far never came near.
std::vector<PolygonTriangle> clip_ears(std::span<const PlanePoint> corners, double rounding);

}  // namespace talweg
