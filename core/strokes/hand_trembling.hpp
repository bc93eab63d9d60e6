// A hand's trembling is the deviation of a stroke from a smooth curve below a scale that the stroke
// itself shows.
#pragma once

#include <optional>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct HandTrembling {
  double amplitude = 0;  ///< of a zigzag as wide as the trembling, mesh units
  double scale = 0;      ///< diameter of the balls that gave the amplitude, mesh units
  /// The amplitude in the middle of each of several parts of equal length; empty where the
  /// amplitude is the same along the whole stroke.
  std::vector<double> along;
};

/// Estimates the trembling of a stroke from the stroke alone. The connected part of the stroke in a
/// ball of diameter s about a place is projected into the mean tangent plane and fitted by a cubic.
/// The root mean square of the rest is the residual, corrected for the degrees of freedom that the
/// cubic takes of the samples in the ball; r(s) is the median residual over the stroke. r grows
/// like s⁴ for a smooth stroke, and like s³ for waves longer than the ball. Where all waves of the
/// trembling fit into the ball, r has a plateau: the slope d log r / d log s is below 0.8.
///
/// The scale of the trembling is the first of the following that exists:
/// - the first plateau after a rise (a slope above 1.2), in balls of up to a third of the stroke or
///   12 mesh edges, whichever is more;
/// - the end of a steep rise: the slope falls below 1.8 after it was above 2.2, with the square of
///   the sensor's noise subtracted from r²;
/// - the plateau of the sensor's noise, which begins at the smallest scale;
/// - the largest ball of up to 12 mesh edges, if r has risen, but grows there more slowly than for
///   a smooth stroke (the slope is below 2.9).
/// The amplitude is √3 r at this scale, which is exact for a zigzag. Without such a scale there is
/// no result.
///
/// Scales grow by √2 from eight times the distance of samples. The largest scale is a sixth of the
/// stroke, so that a dozen waves count as trembling and a few waves do not. Waves of a few mesh
/// edges always count, so for a stroke longer than twelve edges the largest scale is no less than
/// 24 edges (`edge`, mesh units) or 0.6 of the stroke, whichever is less.
///
/// A hand that is fast in some parts and careful in others has an amplitude in each part. A part is
/// halved where r has a plateau in both halves, six balls of that scale fit into each half, and one
/// half trembles more than twice as much as the other.
///
/// Resampling a stroke changes the result only as far as it changes the stroke's shape.
///
/// Plateaus over scales come from scale space (Witkin 1983; Lindeberg 1998); local
/// polynomials of growing support from Savitzky & Golay 1964.
///
/// O(points) and about 2,000 fits of at most 48 points, whatever the stroke.
std::optional<HandTrembling> hand_trembling(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                            double edge);

}  // namespace talweg
