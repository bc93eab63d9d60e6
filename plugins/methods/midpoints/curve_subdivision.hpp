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

/// Points of the curve at equal arc lengths, about `spacing` (mesh units, > 0) apart; of an open
/// curve its ends are among them, of a closed one there are at least four. Throws Error(kBadUsage)
/// where so many, doubled `levels` times, would be more than 20,000.
ControlPolygon control_polygon(const Surface& surface, const SurfaceCurve& curve, double spacing,
                               int levels);

/// One round of the scheme of Lane & Riesenfeld (1980) with geodesics for straight lines: a
/// midpoint goes between each point and the next, then `degree` - 1 times (1 <= degree) every point
/// is replaced by the midpoint of itself and the next. In the plane the rounds tend to the uniform
/// B-spline of that degree. An open polygon keeps its ends. `lines` belongs to `surface`.
/// Throws Error(kBadCurve) where two points cannot be joined.
ControlPolygon subdivided(const Surface& surface, StraightLines& lines,
                          const ControlPolygon& polygon, int degree);

}  // namespace talweg::plugins
