// The corridor's length follows from how large a drawing is.
#pragma once

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The corridor's characteristic length L: a quarter of the largest distance of the drawing's
/// points from their centre of mass (along the curve). With it, tau means the same for a small loop
/// as for a large one. Mesh units.
double corridor_length(const SurfaceMesh& mesh, const SurfaceCurve& drawn);

/// How far from the drawing a result can be, so that faces farther away are not needed: the
/// distance that the corridor allows at tau = 1/8 (φ over a way of 2 L costs more than the length
/// of the drawing), plus a few edges of length `edge`. Mesh units.
double corridor_reach(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge);

}  // namespace talweg
