// Embedding makes drawn curves edge paths of a triangulation.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Checks that a drawn curve has at least two points (three when closed), and that each point and
/// the next lie in a common face. Throws Error(kBadCurve) naming the first position (counted from
/// 1) where this does not hold.
void check_drawn(const Surface& surface, const SurfaceCurve& curve);

struct EmbeddedCurves {
  std::vector<EdgePath> paths;   ///< in the order of the curves
  std::vector<VertexId> pinned;  ///< the vertices at the pins, sorted
};

/// What to do with loops, where a curve comes back to a vertex that it has passed.
enum class Loops { kKeep, kErase };

/// The curves as edge paths, after inserting those of their points that are not vertices. Different
/// curves may touch or share edges. `pins` are points of the curves.
/// With Loops::kErase a path passes no vertex twice: the part between two passages is left out, and
/// of a closed curve the shorter part. Throws Error(kBadCurve) when too little is left, with the
/// curve's number or the one in `names`, and Cancelled when `progress` (stage "embed") says so;
/// points may have been inserted by then. Cost: a PointInsertion for each point and segment. Worse:
/// with Loops::kErase, many loops on one curve, as all points are looked through for each.
EmbeddedCurves embed_curves(SignpostTriangulation& triangulation,
                            std::span<const SurfaceCurve> curves,
                            std::span<const SurfacePoint> pins = {}, Loops loops = Loops::kKeep,
                            std::span<const std::size_t> names = {}, const Progress& progress = {});

}  // namespace talweg
