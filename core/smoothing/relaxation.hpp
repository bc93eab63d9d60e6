// Relaxation moves the points of a curve along the edges that carry them.
#pragma once

#include <span>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct RelaxationOptions {
  int rounds = 5;  ///< how often every point moves; 0 leaves the curve as it is

  /// Throws Error(kBadUsage) naming the field and its bound: 0 <= rounds <= 1,000,000.
  void validate() const;
};

/// The paper's optional post-process (section 4): a constrained Laplacian smoothing of the curve's
/// points on the mesh edges that carry them, as proposed by Lawonn et al. (2014), without splitting
/// or merging of points. Points at vertices and inside faces and the ends of an open curve stay.
///
/// In each round every other point p moves two thirds of the way to the place on its edge that
/// minimises |p - a|²/|a - p0| + |p - b|²/|b - p0|, with neighbours a, b and present place p0: the
/// weighted mean of the neighbours, projected to the edge. The weights are the inverse segment
/// lengths, because then, and not with equal weights, a straight line (also across a bent edge)
/// stays as it is; equal weights can even raise length and curvature. All points move at once
/// (Jacobi), so that the direction of the curve does not matter; the shortened step damps zigzags
/// instead of turning them over.
///
/// The curve's length never grows (but by rounding): the sum of the terms above bounds the length
/// (Weiszfeld), and a Jacobi step, whole or in part, never raises it. Points stay strictly inside
/// their edges, and several points of one edge, of one curve or of several, keep their order, so
/// curves without points inside faces that do not cross do not do so afterwards. They come no
/// nearer to the edge's ends or to each other than 1e-6 of the edge, unless they were.
///
/// O(rounds · points + points log points). Independent of scale and position but for rounding.
/// Throws Cancelled when `progress` (stage "relax") says so; the curves are as they were then.
void relax(const SurfaceMesh& mesh, std::span<SurfaceCurve> curves,
           const RelaxationOptions& options = {}, const Progress& progress = {});

/// The same for one curve.
void relax(const SurfaceMesh& mesh, SurfaceCurve& curve, const RelaxationOptions& options = {},
           const Progress& progress = {});

}  // namespace talweg
