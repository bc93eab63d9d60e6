// The sheet on which a drawing is smoothed is chosen by how fine it is and whether it crosses.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/smoothing/sheet.hpp"

namespace talweg {

/// Divides faces where the drawing is finer than they are, but for the paper's method, and is
/// undivided_sheet_for() otherwise. `distance`: the paper's distance per mesh vertex, used as it
/// is. Refers to the memory and the drawing. Throws as embed_curves() does, and Cancelled. Cost:
/// that of undivided_sheet_for(); of dividing where it is needed.
std::unique_ptr<Sheet> sheet_for(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                 const CurveOptions& options,
                                 std::optional<std::vector<double>> distance,
                                 const Progress& progress);

}  // namespace talweg
