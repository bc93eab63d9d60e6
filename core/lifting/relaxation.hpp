// Relaxation moves the points of a curve along the edges that carry them.
#pragma once

#include <span>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct RelaxationOptions {
  int rounds = 5;  ///< how often every point moves; 0 leaves the curve as it is
  std::span<const SurfacePoint> fixed = {};  ///< further points of the curves that stay

  /// Throws Error(kBadUsage) naming the field and its bound: 0 <= rounds <= 1,000,000.
  void validate() const;
};

/// The paper's optional post-process (section 4): a constrained Laplacian smoothing of the curve's
/// points on the mesh edges that carry them, as proposed by Lawonn et al. (2014), without splitting
/// or merging of points. Points at vertices and inside faces and the ends of an open curve stay.
///
/// In each round every other point p moves two thirds of the way to the place on its edge that
/// minimises |p - a|²/|a - p0| + |p - b|²/|b - p0|, where a and b are its neighbours and p0 is its
/// present place. This place is the weighted mean of the neighbours, projected to the edge. With
/// inverse segment lengths as weights a straight line (also across a bent edge) stays as it is;
/// equal weights can even raise length and curvature. All points move at once (Jacobi), so that the
/// direction of the curve does not matter; the shortened step damps zigzags instead of inverting
/// them.
///
/// The curve's length never grows, except by rounding: the sum of the terms above bounds the length
/// (Weiszfeld), and a Jacobi step, whole or in part, never raises it. Points stay strictly inside
/// their edges, and the points on one edge, of one curve or several, keep their order. So curves
/// that do not cross, and have no points inside faces, do not cross afterwards. Points do not come
/// nearer to the edge's ends or to each other than 1e-6 of the edge, unless they already were.
///
/// O(rounds · points + points log points). Independent of scale and position but for rounding.
/// Throws Cancelled when `progress` (stage "relax") returns false; the curves are unchanged then.
void relax(const SurfaceMesh& mesh, std::span<SurfaceCurve> curves,
           const RelaxationOptions& options = {}, const Progress& progress = {});

/// The same for one curve.
void relax(const SurfaceMesh& mesh, SurfaceCurve& curve, const RelaxationOptions& options = {},
           const Progress& progress = {});

}  // namespace talweg
