// The measures of a curve on a surface are its length, its geodesic curvature, and how that is
// spread.
#pragma once

#include <cstddef>

#include "talweg/core/measure/turning_windows.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Length and discrete geodesic curvature of a piecewise straight curve, from edge lengths only.
/// The last three need an edge length h to compare with: see turning_windows.hpp.
struct CurveMeasures {
  double length = 0;           ///< mesh units
  double total_curvature = 0;  ///< radians: sum of the turning angles
  double signed_curvature =
      0;                     ///< radians: left turns less right turns; on a loop Gauss and Bonnet's
  double max_curvature = 0;  ///< radians: the largest PointTurn::from_straight
  std::size_t max_at = 0;    ///< index of the point that turns most; the first if several do
  double bending = 0;        ///< without unit: h times the integral of the squared curvature
  double window_turning = 0;    ///< radians: the largest net turning in a window of length h
  double window_turning_2 = 0;  ///< radians: the same in one of 2 h
};

/// The turning angle at a point of a curve, in [0, pi] radians: pi minus the smaller of the two
/// side angles, which are measured along the surface between the directions to the neighbours. It
/// is 0 where both are at least pi (a curve through a saddle vertex can be straight without being
/// straight on either side; Polthier & Schmies 1998). Inside an edge or a face the side angles sum
/// to 2 pi, and this is the angle between the segments with the two faces unfolded into one plane.
/// On the boundary only the side inside the surface counts; the other is taken as infinite. Needles
/// and zero-area triangles give some angle in that range, never NaN. O(degree). Throws
/// Error(kBadCurve) when a neighbour shares no face with the point.
double turning_angle(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                     const SurfacePoint& after);

/// Half the difference between the right and the left side angle, radians: positive where the curve
/// turns left. Inside an edge or a face its absolute value is the turning angle. On the boundary it
/// is pi minus the angle on the inner side, with its sign. Throws as turning_angle() does.
double signed_turning(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                      const SurfacePoint& after);

/// Both of them, and how far the curve is from the passage that has the same angle on both sides
/// (the straightest one of Polthier & Schmies 1998): what the eye takes for a kink. Straight over
/// a spike it is 0 where the turning angle is not, and at a saddle vertex it is more than that. On
/// the boundary it is the turning angle.
struct PointTurn {
  double angle = 0;          ///< turning_angle()
  double toward_left = 0;    ///< signed_turning()
  double from_straight = 0;  ///< radians, >= 0
};
PointTurn turn_of(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                  const SurfacePoint& after);

/// The length of a curve in mesh units, each segment measured in its common face; 0 for fewer than
/// two points. Throws Error(kBadCurve) naming the first pair of points without a common face.
double curve_length(const Surface& surface, const SurfaceCurve& curve);

/// The turns of a curve, for turning_windows.hpp. Its ends do not turn where it is open. O(points ·
/// degree). Throws Error(kBadCurve) as curve_length() does.
CurveTurns turns_of(const Surface& surface, const SurfaceCurve& curve);

/// Length and turning angles of a curve. The ends of an open curve do not turn; a closed one turns
/// at every point. Bending and windows stay 0. O(points · degree). Throws Error(kBadCurve) as
/// curve_length() does.
CurveMeasures measure_curve(const Surface& surface, const SurfaceCurve& curve);

/// All measures. `edge` > 0, mesh units: the length that windows are compared with, for a result
/// and its drawing the same edge_length_near() the drawing.
CurveMeasures measure_curve(const Surface& surface, const SurfaceCurve& curve, double edge);

}  // namespace talweg
