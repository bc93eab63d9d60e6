// The gallery shows the drawing, the paper's potential and the default, side by side.
#pragma once

#include <filesystem>
#include <string>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// Whether this mesh is one of the gallery's.
bool in_gallery(const std::string& mesh);

/// The subject's first stored drawing where there is one, else its longest open one; its place that
/// turns most, drawn, smoothed with the paper's potential and with the default, all at τ = 1.
/// Needs a subject with drawings. Throws Error(kBadFile) when the file cannot be written.
void write_gallery_picture(const Subject& subject, const std::filesystem::path& file);

}  // namespace talweg::quality
