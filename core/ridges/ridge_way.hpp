// A ridge way is the cheapest path through the gates of a drawing, along ridges where that costs
// less.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/ridges/ridge_field.hpp"
#include "talweg/core/ridges/ridge_gates.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A point of the way.
struct RidgeStep {
  SurfacePoint point;
  std::optional<std::size_t> drawn;  ///< the point of the drawing at this step
  std::optional<std::size_t> gate;   ///< the gate that the way passes here
  bool ridge_next = false;           ///< whether a ridge leads to the next step
};

/// The cheapest way through all gates (RidgeCorridor has the costs): each leg is searched once,
/// from all places at which the way may enter it. Of a loop none of whose gates stays, the first
/// search only decides where it passes the gate that is farthest from its beginning; the second
/// begins and ends there. Coincident steps are one; a closed way does not repeat its first step.
/// Throws Cancelled. O(corridors), see RidgeCorridor.
std::vector<RidgeStep> ridge_way(const SurfaceMesh& mesh, RidgeField& field,
                                 const SurfaceCurve& curve, const RidgeGates& gates,
                                 double strength, ProgressPoller& poller);

}  // namespace talweg
