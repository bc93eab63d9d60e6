// A hand's trembling is what a stroke does within a scale at which its way stands still.
#pragma once

#include <optional>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct HandTrembling {
  double amplitude = 0;  ///< of the zigzag that is as wide as the trembling, mesh units
  double scale = 0;      ///< diameter of the balls in which it was found, mesh units
  /// The same in the middle of each of several parts of equal length; empty where the hand is the
  /// same all along.
  std::vector<double> along;
};

/// Estimates the trembling of a stroke from the stroke alone. What lies connected in a ball of
/// diameter s about a place of the stroke is laid into the mean tangent plane; across it, the root
/// mean square of what a cubic leaves is the residual (less the degrees of freedom that the cubic
/// takes of the samples in the ball); r(s) is the median over the stroke. It grows like s⁴ where a
/// smooth way is all that there is, and like s³ for waves that are longer than the ball. Where all
/// waves of the trembling fit into the ball it stands still: there d log r / d log s < 0.8, after
/// it was above 1.2, and the amplitude is √3 r, which is that of a zigzag. A sensor's noise stands
/// still from the smallest scale on; it is the answer only where nothing rises above it and stands
/// still again, in balls of up to a third of the stroke, or 12 mesh edges, or rises steeply. If
/// nothing stands still, what counts is the end of the steep rise, for which the noise is taken off
/// r in squares (the slope falls below 1.8 from above 2.2); else the noise; else the largest ball
/// of up to 12 mesh edges, if r does not grow there as it does for a smooth way (the slope is below
/// 2.9). Without that there is no answer.
///
/// Scales grow by √2 from eight times the distance of samples. The largest is a sixth of the
/// stroke, so that a dozen waves are a trembling and a few are not; but waves of a few mesh edges
/// are one anyway, so it is no less than 24 edges (`edge`, mesh units) or 0.6 of the stroke,
/// whichever is less, for a stroke that is longer than twelve edges.
///
/// A hand that is fast here and careful there has an amplitude in each part: a part is halved where
/// r stands still in both halves, six balls of that size fit into each, and one trembles more than
/// twice as much as the other.
///
/// Resampling a stroke changes the result only by what the stroke itself changes.
///
/// The idea of looking for the scale at which a curve stands still is that of scale space (Witkin
/// 1983; Lindeberg 1998); local polynomials of growing support are those of Savitzky & Golay 1964.
///
/// O(points) and about 2,000 fits of at most 48 points, whatever the stroke.
std::optional<HandTrembling> hand_trembling(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                            double edge);

}  // namespace talweg
