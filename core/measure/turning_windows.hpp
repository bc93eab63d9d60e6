// Turning windows measure whether the turning of a curve is spread evenly or concentrated in kinks.
#pragma once

#include <vector>

namespace talweg {

/// The turns of a curve, in order.
struct CurveTurns {
  std::vector<double> at;     ///< mesh units along the curve, ascending, in [0, length]
  std::vector<double> angle;  ///< signed_turning(), radians
  double length = 0;          ///< of the curve, mesh units
  bool closed = false;        ///< windows then reach over the end; never longer than the curve
};

/// The discrete integral of the squared geodesic curvature, `edge` ∫ (T(s) / w)² ds, where w is
/// half of `edge` and T(s) is the sum of the turns in the window of length w about s. The value has
/// no unit: it does not depend on the scale and, for smooth curves, hardly on the number of points.
/// A single kink of angle a has 2 a². `edge` > 0, mesh units. O(turns).
double bending(const CurveTurns& turns, double edge);

/// A stretch of a curve with constant window curvature.
struct CurvatureStep {
  double from = 0, to = 0;  ///< mesh units along the curve, from < to
  double curvature = 0;     ///< radians per mesh unit; left positive
};

/// The signed geodesic curvature along a curve: at each position the sum of the turns in the window
/// (mesh units, > 0) about it, divided by the length of the window. The steps cover [0, length] in
/// order. Beyond the end of an open curve there are no turns. Empty for a curve without length.
/// O(turns).
std::vector<CurvatureStep> curvature_along(const CurveTurns& turns, double window);

/// The largest absolute sum of the turns in any window of the given length (mesh units), radians.
/// O(turns).
double window_turning(const CurveTurns& turns, double window);

}  // namespace talweg
