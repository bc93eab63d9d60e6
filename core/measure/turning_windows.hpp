// Windows along a curve tell how its turning is spread: evenly, or in a few kinks.
#pragma once

#include <vector>

namespace talweg {

/// The turns of a curve in their order.
struct CurveTurns {
  std::vector<double> at;     ///< mesh units along the curve, ascending, in [0, length]
  std::vector<double> angle;  ///< signed_turning(), radians
  double length = 0;          ///< of the curve, mesh units
  bool closed = false;        ///< windows then reach over the end; they are never longer than it
};

/// The discrete integral of the squared geodesic curvature, `edge` ∫ (T(s) / w)² ds with w half an
/// edge length and T(s) the sum of the turns in the window of length w about s. Without unit: the
/// same at any scale and, for smooth curves, for any number of points. One kink of angle a alone
/// bends by 2 a². `edge` > 0, mesh units. O(turns).
double bending(const CurveTurns& turns, double edge);

/// A stretch of a curve with one mean curvature.
struct CurvatureStep {
  double from = 0, to = 0;  ///< mesh units along the curve, from < to
  double curvature = 0;     ///< radians per mesh unit; left positive
};

/// The signed geodesic curvature along a curve: at each place the sum of the turns in the window of
/// this length (mesh units, > 0) about it, over the window's length. The steps cover [0, length] in
/// their order. Windows that reach over an open curve's end find no turns there. Empty for a curve
/// without length. O(turns).
std::vector<CurvatureStep> curvature_along(const CurveTurns& turns, double window);

/// The largest absolute sum of the turns in any window of this length (mesh units), radians.
/// O(turns).
double window_turning(const CurveTurns& turns, double window);

}  // namespace talweg
