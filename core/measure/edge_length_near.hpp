// The edge length near a curve measures the resolution of the mesh there.
#pragma once

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// h₀: the mean length of the mesh edges within two rings of the curve, mesh units. The rings are
/// around the vertices of the curve, and the corners of the edges and faces with its points.
/// O(points · degree²).
double edge_length_near(const Surface& surface, const SurfaceCurve& curve);

}  // namespace talweg
