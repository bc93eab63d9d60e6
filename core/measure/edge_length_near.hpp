// The edge length near a drawing tells how fine the mesh is there.
#pragma once

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// h₀: the mean length of the mesh edges within two rings of the curve (rings around the corners of
/// the edges and faces that its points lie in), mesh units. O(points · degree²).
double edge_length_near(const Surface& surface, const SurfaceCurve& curve);

}  // namespace talweg
