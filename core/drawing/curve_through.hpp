// A curve through vertices runs along the mesh's edges from each vertex to the next.
#pragma once

#include <span>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A curve along mesh edges through these vertices; a list that ends with its first vertex is
/// closed. Throws Error(kBadCurve) as check_drawn does. O(vertices).
SurfaceCurve curve_through(const Surface& surface, std::span<const VertexId> vertices);

}  // namespace talweg
