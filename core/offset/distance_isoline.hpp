// A distance isoline is the set of surface points at one distance from given curves.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/offset/face_level.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// One component of an isoline; the nearer side is on its left. A component is closed, or begins
/// and ends on the boundary of the mesh.
struct LevelCurve {
  bool closed = false;
  std::vector<SurfacePoint> points;  ///< a closed curve does not repeat its first point
  std::vector<FaceId> faces;  ///< per point, a face that contains the point and the next point
};

/// Traces the isoline at `choice.level`. `distance` must be set to `curves`. Components that begin
/// on the boundary come first, closed components after them. The distance of the points is the
/// level times 1 + 1e-11, up to rounding, so an isoline along edges of the mesh passes just beyond
/// their vertices. A node closer to a vertex than 1e-9 of the edge is put on the vertex. Only faces
/// nearer than the level are visited. Memory O(faces + edges), set to zero at once. Throws
/// Cancelled if the poller of `distance` does.
std::vector<LevelCurve> distance_isoline(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         PolylineDistance& distance, const LevelChoice& choice);

}  // namespace talweg
