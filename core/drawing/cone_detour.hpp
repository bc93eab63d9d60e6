// A cone detour is a straight line on the longer side of a vertex of positive curvature.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// An edge path beside a line, from its first to its last point, and the vertex of the path on
/// whose other side the line probably gets shorter.
struct ConeDetour {
  std::vector<VertexId> chain;  ///< between the ends; corners of the faces that the line crosses
  VertexId over;                ///< one of `chain`
};

/// The vertex beside a straight line on whose other side its section of the line would probably get
/// shortest, relative to the length of the section; none if no section promises to get shorter by a
/// thousandth. The sections of a line are its parts between successive vertices on the line, or
/// ends of the line. Seen from a vertex, the section spans an angle. If this angle is more than
/// half of the vertex's cone angle, the way around the other side is shorter, as far as the surface
/// near the line is this cone. `line` is a geodesic whose points lie at vertices and on crossed
/// edges, except its ends. O(faces that the line crosses and that meet at their corners).
std::optional<ConeDetour> cone_detour(SignpostTriangulation& triangulation, const Surface& surface,
                                      std::span<const SurfacePoint> line);

}  // namespace talweg
