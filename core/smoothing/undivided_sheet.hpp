// An undivided domain has the faces of its mesh as they are: the whole mesh, or strips of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/smoothing/sheet.hpp"

namespace talweg {

/// Unrolls curves that cross themselves or each other, and takes the mesh as it is otherwise.
/// `fence`: for a part of a mesh, see EmbeddedDrawing::Ground; null for none. `distance`: the
/// paper's distance per mesh vertex, used as it is. Refers to the memory and the drawing. Throws as
/// embed_curves() does, and Cancelled. Cost: that of embedding the curves and of path_contacts();
/// of unrolling where it is needed, after which they are embedded again.
std::unique_ptr<SmoothingDomain> undivided_domain_for(SmoothingMemory& memory,
                                                      const OrderedDrawing& drawing,
                                                      const CurveOptions& options,
                                                      const std::vector<bool>* fence,
                                                      std::optional<std::vector<double>> distance,
                                                      const Progress& progress);

}  // namespace talweg
