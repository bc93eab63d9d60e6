// The corridor's length is computed from the size of a drawing.
#pragma once

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The corridor's characteristic length L, mesh units: a quarter of the largest distance of the
/// drawing's points from the curve's centre of mass. L makes the effect of tau independent of the
/// size of a loop.
double corridor_length(const SurfaceMesh& mesh, const SurfaceCurve& drawn);

/// A bound of the distance between result and drawing, mesh units; faces farther away are not
/// needed. The bound is the distance that the corridor allows at tau = 1/8 (a way over the
/// potential at 2 L is longer than the drawing), plus a few edges of length `edge`.
double corridor_reach(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge);

}  // namespace talweg
