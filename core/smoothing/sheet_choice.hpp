// The domain on which a drawing is smoothed is chosen by how rough the mesh is, how fine the
// drawing is, and whether it crosses.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/smoothing/sheet.hpp"

namespace talweg {

/// Smooths on the mesh's ground where the mesh is rough along the drawing, but for the paper's
/// method, and is domain_on() the mesh otherwise. `distance`: the paper's distance per mesh vertex,
/// used as it is; `roughness`: roughness_along() the drawing. Refers to the memory and the drawing.
/// Throws as embed_curves() does, and Cancelled. Cost: domain_on(), and the first time on a rough
/// mesh its ground.
std::unique_ptr<SmoothingDomain> domain_for(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                            const CurveOptions& options,
                                            std::optional<std::vector<double>> distance,
                                            double roughness, const Progress& progress);

/// Divides faces where the drawing is finer than they are, but for the paper's method, and is
/// undivided_domain_for() otherwise. Cost: that of undivided_domain_for(); of dividing where it is
/// needed.
std::unique_ptr<SmoothingDomain> domain_on(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                           const CurveOptions& options,
                                           std::optional<std::vector<double>> distance,
                                           const Progress& progress);

}  // namespace talweg
