// Curve subdivision refines a curve on a surface by geodesic midpoints.
#pragma once

#include <vector>

#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

/// The corners of a polygon of geodesics.
struct ControlPolygon {
  bool closed = false;
  std::vector<SurfacePoint> points;
};

/// Points of the curve at equal arc lengths, about `spacing` (mesh units, > 0) apart. For an open
/// curve they include its ends; for a closed one there are at least four. Throws Error(kBadUsage)
/// if the points, doubled `levels` times, would be more than 20,000.
ControlPolygon control_polygon(const Surface& surface, const SurfaceCurve& curve, double spacing,
                               int levels);

/// One round of the scheme of Lane & Riesenfeld (1980) with geodesics instead of straight lines: a
/// midpoint is inserted between each point and the next, then `degree` - 1 times (1 <= degree)
/// every point is replaced by the midpoint of itself and the next. In the plane the rounds converge
/// to the uniform B-spline of that degree. An open polygon keeps its ends. `lines` must belong to
/// `surface`.
/// Throws Error(kBadCurve) where two points cannot be joined.
ControlPolygon subdivided(const Surface& surface, StraightLines& lines,
                          const ControlPolygon& polygon, int degree);

}  // namespace talweg::plugins
