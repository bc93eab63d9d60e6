// Strokes with any number of points in one face.
#pragma once

#include <cmath>
#include <cstddef>

#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::test {

/// n points of a wave through a face, away from its sides.
inline SurfaceCurve stroke_in(const Surface& surface, FaceId face, std::size_t n) {
  SurfaceCurve curve;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double b = 0.1 + 0.6 * x, c = 0.15 + 0.1 * std::sin(12 * x);
    curve.points.push_back(SurfacePoint::in_face(surface, face, {1 - b - c, b, c}));
  }
  return curve;
}

}  // namespace talweg::test
