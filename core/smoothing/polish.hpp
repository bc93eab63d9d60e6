// The polish takes the last kinks out of a straightened curve.
#pragma once

#include <cstddef>
#include <span>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/lifted_chain.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct PolishOptions {
  int max_rounds = 24;      ///< of Newton's method followed by passing over vertices; >= 0
  int newton_steps = 12;    ///< per round
  double tolerance = 1e-7;  ///< relative gain in length below which it ends; > 0

  /// Throws Error(kBadUsage) naming the field and its bound.
  void validate() const;
};

struct PolishResult {
  double length_before = 0;  ///< lifted, with the exact potential at the points and halfway between
  double length_after = 0;   ///< never more than length_before
  std::size_t passed_vertices = 0;
};

/// Minimises the lifted length Σ √(|p−q|² + |Φp−Φq|²) of a curve over the positions of its points
/// on their edges by a tridiagonal Newton method. The potential is evaluated exactly, at the points
/// and halfway between any two. FlipOut's result bends where the piecewise linear potential has its
/// creases, that is, at mesh edges. The polished curve does not show the mesh, except that its
/// points lie on edges. A point that is driven to the end of its edge goes around the vertex there,
/// or stays at it, whichever is shorter.
///
/// The ends of an open curve and the points in `pinned` stay. Points inside faces are dropped where
/// their neighbours share the face, since the curve is straight there. Throws Cancelled when
/// `progress` (stage "polish") says so; the curve is as it was then.
PolishResult polish(const SurfaceMesh& mesh, SurfaceCurve& curve, const ExactPotential& potential,
                    std::span<const SurfacePoint> pinned, const PolishOptions& options = {},
                    const Progress& progress = {});

}  // namespace talweg
