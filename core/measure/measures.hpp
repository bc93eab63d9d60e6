// The measures of a curve on a surface are its length, its geodesic curvature, its bending, and its
// tortuosity in space.
#pragma once

#include <cmath>
#include <cstddef>

#include "talweg/core/measure/turning_windows.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

class SurfaceMesh;

/// Length and discrete geodesic curvature of a piecewise straight curve, from edge lengths only,
/// and the tortuosity from positions. Bending and the window turnings depend on an edge length h
/// (turning_windows.hpp).
struct CurveMeasures {
  double length = 0;            ///< mesh units
  double total_curvature = 0;   ///< radians: sum of the turning angles
  double signed_curvature = 0;  ///< radians: left minus right turns, as in Gauss-Bonnet
  double max_curvature = 0;     ///< radians: the largest PointTurn::from_straight
  std::size_t max_at = 0;       ///< index of the first point with this turn
  double bending = 0;           ///< no unit: h times the integral of the squared curvature
  double window_turning = 0;    ///< radians: the largest net turning in a window of length h
  double window_turning_2 = 0;  ///< radians: the same for windows of length 2 h
  /// No unit, at least 1 up to rounding: the length divided by the straight distance in space
  /// between the ends. Infinite for loops, for open curves whose ends coincide, and if positions
  /// are not known.
  double tortuosity = HUGE_VAL;
};

/// The turning angle at a point of a curve, in [0, pi] radians: pi minus the smaller of the two
/// side angles. A side angle is the angle along the surface between the directions to the two
/// neighbours, on one side of the curve. The turning angle is 0 if both side angles are at least
/// pi, as a curve through a saddle vertex can be (Polthier & Schmies 1998). Inside an edge or a
/// face the side angles sum to 2 pi, and the turning angle is the angle between the segments with
/// the two faces unfolded into one plane. On the boundary the side outside the surface counts as
/// infinite. Needles and zero-area triangles give some angle in [0, pi], never NaN. O(degree).
/// Throws Error(kBadCurve) if a neighbour shares no face with the point.
double turning_angle(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                     const SurfacePoint& after);

/// Half the difference between the right and the left side angle, radians; positive for left turns.
/// Inside an edge or a face the absolute value is the turning angle. On the boundary the value is
/// pi minus the inner side angle, negated if the inner side is on the right. Throws as
/// turning_angle() does.
double signed_turning(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                      const SurfacePoint& after);

/// The turn at a point of a curve. `from_straight` is the angle to the straightest passage of
/// Polthier & Schmies (1998), which has equal angles on both sides; the eye sees this angle as a
/// kink. For a straight passage over a spike it is 0, while the turning angle is positive; at a
/// saddle vertex it is at least the turning angle. On the boundary it equals the turning angle.
struct PointTurn {
  double angle = 0;          ///< turning_angle()
  double toward_left = 0;    ///< signed_turning()
  double from_straight = 0;  ///< radians, >= 0
};
PointTurn turn_of(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                  const SurfacePoint& after);

/// The length of a curve in mesh units, with each segment measured in its face; 0 for fewer than
/// two points. Throws Error(kBadCurve) with the first pair of points without a common face.
double curve_length(const Surface& surface, const SurfaceCurve& curve);

/// The turns of a curve, for turning_windows.hpp. The ends of an open curve have no turn. O(points
/// · degree). Throws Error(kBadCurve) as curve_length() does.
CurveTurns turns_of(const Surface& surface, const SurfaceCurve& curve);

/// Length and turning angles of a curve. The ends of an open curve have no turn. `bending` and the
/// window turnings stay 0, the tortuosity is infinite. O(points · degree). Throws Error(kBadCurve)
/// as curve_length() does.
CurveMeasures measure_curve(const Surface& surface, const SurfaceCurve& curve);

/// All measures but the tortuosity. `edge` (mesh units, > 0) is h; for a drawing and its result use
/// edge_length_near() of the drawing for both.
CurveMeasures measure_curve(const Surface& surface, const SurfaceCurve& curve, double edge);

/// All measures of a curve.
CurveMeasures measure_curve(const SurfaceMesh& mesh, const SurfaceCurve& curve, double edge);

}  // namespace talweg
