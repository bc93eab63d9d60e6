// Embedding turns drawn curves into edge paths of a triangulation.
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

/// Whether loops stay, where a curve returns to a vertex that it has passed.
enum class Loops { kKeep, kErase };

/// The curves as edge paths; points that are not vertices are inserted first. Different curves may
/// touch or share edges. `pins` are points of the curves.
///
/// With Loops::kErase a path passes no vertex twice: the part between two passages is left out, and
/// for a closed curve the shorter of the two parts. Throws Error(kBadCurve) with the curve's
/// number, or its entry in `names`, when the rest is too short to be a curve. Throws Cancelled when
/// `progress` (stage "embed") says so; some points may have been inserted by then. Cost: a
/// PointInsertion for each point and segment; with Loops::kErase, each loop of a curve adds a pass
/// over the curve's points.
EmbeddedCurves embed_curves(SignpostTriangulation& triangulation,
                            std::span<const SurfaceCurve> curves,
                            std::span<const SurfacePoint> pins = {}, Loops loops = Loops::kKeep,
                            std::span<const std::size_t> names = {}, const Progress& progress = {});

}  // namespace talweg
