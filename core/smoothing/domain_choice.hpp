// The choice of a domain depends on the roughness of the mesh, the fineness of the drawing, and its
// crossings.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/smoothing/smoothing_domain.hpp"

namespace talweg {

/// A GroundDomain for the corridor on a mesh that is rough along the drawing, else domain_on() the
/// mesh. `distance`: a given paper's distance per mesh vertex, used unchanged; `roughness`:
/// roughness_along() of the drawing. The domain refers to the memory and the drawing. Throws as
/// embed_curves() does, and Cancelled. Cost: domain_on(), and on a rough mesh once smooth_ground().
std::unique_ptr<SmoothingDomain> domain_for(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                            const CurveOptions& options,
                                            std::optional<std::vector<double>> distance,
                                            double roughness, const Progress& progress);

/// A RefinedDomain for the corridor if a face is too large for the drawing, else
/// undivided_domain_for(). Cost: undivided_domain_for(), plus the division of faces if needed.
std::unique_ptr<SmoothingDomain> domain_on(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                           const CurveOptions& options,
                                           std::optional<std::vector<double>> distance,
                                           const Progress& progress);

}  // namespace talweg
