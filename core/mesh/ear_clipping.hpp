// Ear clipping triangulates a polygon in the plane.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/plane_point.hpp"

namespace talweg {

/// The corners of a triangle, as positions along the polygon.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Twice the signed area of a triangle, with a bound of its error if coordinates are rounded by
/// `rounding`.
struct TurnInPlane {
  double area = 0;
  double error = 0;
  TurnInPlane(PlanePoint a, PlanePoint b, PlanePoint c, double rounding);
  [[nodiscard]] bool left() const { return area > error; }
  [[nodiscard]] bool right() const { return area < -error; }
};

/// Triangulates a counterclockwise polygon of n >= 3 corners into n - 2 counterclockwise triangles.
/// Triangles of zero area occur only if the remaining corners coincide or are collinear. The first
/// triangle begins with the corners 0 and 1. Two corners may have the same position, as along a
/// bridge to a hole. `rounding` is the rounding error of the coordinates.
///
/// The result is empty for a polygon that crosses itself. Source: Meisters 1975, "Polygons have
/// ears". Whether a corner is an ear changes only when a neighbour is cut off; a tree of the reflex
/// corners finds the corners inside an ear; the shortest cuts come first. O(n log n) on typical
/// polygons. After 1000 n steps the result is empty, too; no tested polygon came near this limit.
std::vector<PolygonTriangle> clip_ears(std::span<const PlanePoint> corners, double rounding);

}  // namespace talweg
