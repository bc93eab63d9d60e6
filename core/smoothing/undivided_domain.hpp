// An undivided domain has undivided faces of its mesh: the whole mesh, or strips of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/smoothing/smoothing_domain.hpp"

namespace talweg {

/// An UnrolledDomain for curves that cross themselves or each other, else a MeshDomain. Crossing
/// curves that consist of legs only also get a MeshDomain. `fence`: for a part of a mesh
/// (EmbeddedDrawing::Ground), or null. `distance`: a given paper's distance per mesh vertex, used
/// unchanged. The domain refers to the memory and the drawing. Throws as embed_curves() does, and
/// Cancelled. Cost: embedding and path_contacts(), plus unrolling and embedding again if needed.
std::unique_ptr<SmoothingDomain> undivided_domain_for(SmoothingMemory& memory,
                                                      const OrderedDrawing& drawing,
                                                      const CurveOptions& options,
                                                      const std::vector<bool>* fence,
                                                      std::optional<std::vector<double>> distance,
                                                      const Progress& progress);

}  // namespace talweg
