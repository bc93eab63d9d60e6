// A distance isoline is the curves of all points that are equally far from some curves.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/offset/face_level.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// One component of an isoline, with what is nearer on its left. It is closed, or begins and ends
/// on the boundary of the mesh.
struct LevelCurve {
  bool closed = false;
  std::vector<SurfacePoint> points;  ///< a closed curve's first is not repeated
  std::vector<FaceId> faces;         ///< one that contains the point and the next
};

/// The points whose distance is `choice.level`, which `distance` must be set to `curves` for: first
/// components that begin on the boundary, then closed ones. The distance of every point is the
/// level times 1 + 1e-11, up to rounding: so an isoline along edges of the mesh is one that passes
/// just beyond their vertices, and is put on them where it is within 1e-9 of an edge.
/// Only faces nearer than the level are visited. Memory O(faces + edges), set to zero at once.
/// Throws Cancelled if the poller of `distance` does.
std::vector<LevelCurve> distance_isoline(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         PolylineDistance& distance, const LevelChoice& choice);

}  // namespace talweg
