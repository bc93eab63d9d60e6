// The gallery shows the drawing, the taut and the fair curve, and how their turning is spread.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// The subject's stored drawings where there are any, else its longest open one.
std::vector<NamedPath> gallery_drawings(const Subject& subject);

/// One of the subject's drawings at the place where the taut curve turns most within an edge
/// length: drawn, taut and fair, at τ = 1. Beneath it the curvature along all three. Throws
/// Error(kBadFile) when the file cannot be written.
void write_gallery_picture(const Subject& subject, const NamedPath& drawing,
                           const std::filesystem::path& file);

}  // namespace talweg::quality
