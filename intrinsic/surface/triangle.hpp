// Angles, area and layout of a triangle follow from its side lengths. Formulas are clamped, so
// lengths that violate the triangle inequality by rounding give flat triangles and never NaN.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "talweg/intrinsic/surface/plane_point.hpp"

namespace talweg {

/// The angle opposite side c, between sides a and b, in [0, pi]. Kahan, "Miscalculating area and
/// angles of a needle-like triangle" (2014): relative error of a few ulp, also for needles. A side
/// of length 0 between equal sides gives pi/2 at its ends, and three sides of length 0 give pi/3,
/// so that angles always sum to pi.
inline double angle_between(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (b <= 0) return a <= 0 && c <= 0 ? std::numbers::pi / 3 : std::numbers::pi / 2;
  const double mu = b >= c ? c - (a - b) : b - (a - c);
  if (mu <= 0) return b >= c || c <= a - b ? 0.0 : std::numbers::pi;
  const double denominator = (a + (b + c)) * ((a - c) + b);
  if (denominator <= 0) return std::numbers::pi;
  return 2 * std::atan(std::sqrt(((a - b) + c) * mu / denominator));
}

/// Heron's formula in Kahan's stable form; 0 if the triangle inequality does not hold.
inline double triangle_area(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return product > 0 ? std::sqrt(product) / 4 : 0.0;
}

/// The apex of a triangle whose base runs from (0, 0) to (base, 0); y >= 0.
/// `left` and `right` are the distances of the apex from the two ends.
inline PlanePoint apex(double base, double left, double right) {
  if (base <= 0) return {0, left};
  const double x = (base + (left - right) * ((left + right) / base)) / 2;
  return {x, 2 * triangle_area(base, left, right) / base};
}

}  // namespace talweg
