// A ridge way is the cheapest path through the gates of a drawing; it follows ridges where they
// cost less than the drawing.
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

/// The cheapest way through all gates (RidgeCorridor has the costs). Each leg is searched once,
/// from all places at which the way may enter the leg. A loop without a fixed gate is searched
/// twice: the first search only finds the place at which the way passes the gate halfway around,
/// and the second search begins and ends at this place. Coincident steps are one; a closed way does
/// not repeat its first step. Throws Cancelled. O(corridors), see RidgeCorridor.
std::vector<RidgeStep> ridge_way(const SurfaceMesh& mesh, RidgeField& field,
                                 const SurfaceCurve& curve, const RidgeGates& gates,
                                 double strength, ProgressPoller& poller);

}  // namespace talweg
