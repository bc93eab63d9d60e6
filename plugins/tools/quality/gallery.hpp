// Pictures of the drawing, the taut and the fair curve, with plots of their curvature.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// The subject's stored drawings; without any, its longest open drawing.
std::vector<NamedPath> gallery_drawings(const Subject& subject);

/// One of the subject's drawings at the place where the taut curve turns most within an edge
/// length: drawn, taut and fair, at τ = 1. A plot below has the curvature along all three. Throws
/// Error(kBadFile) if the file cannot be written.
void write_gallery_picture(const Subject& subject, const NamedPath& drawing,
                           const std::filesystem::path& file);

}  // namespace talweg::quality
