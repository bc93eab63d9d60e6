// Embedding makes drawn curves edge paths of a triangulation.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// What a drawn curve must be: at least two points (three when closed), each point and the next in
/// a common face. Throws Error(kBadCurve) naming the first position (counted from
/// 1) that is not so.
void check_drawn(const Surface& surface, const SurfaceCurve& curve);

struct EmbeddedCurves {
  std::vector<EdgePath> paths;   ///< in the order of the curves
  std::vector<VertexId> pinned;  ///< the vertices at the pins, sorted
};

/// What becomes of loops, where a curve comes back to a vertex it has passed.
enum class Loops { kKeep, kErase };

/// The curves as edge paths, after inserting those of their points that are not vertices. Different
/// curves may touch or share edges. `pins` are points of the curves.
/// With Loops::kErase a path passes no vertex twice: what lies between is left out, of a closed
/// curve the shorter part. Throws Error(kBadCurve) when too little is left, with the curve's
/// number, or that in `names`, and Cancelled when `progress` (stage "embed") says so; points may
/// have been inserted by then.
EmbeddedCurves embed_curves(SignpostTriangulation& triangulation,
                            std::span<const SurfaceCurve> curves,
                            std::span<const SurfacePoint> pins = {}, Loops loops = Loops::kKeep,
                            std::span<const std::size_t> names = {}, const Progress& progress = {});

}  // namespace talweg
