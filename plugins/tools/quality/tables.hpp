// Tables of the measures.
#pragma once

#include <span>
#include <string>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// Whether the drawing turns by 25 rad or more. Other drawings are left out where curvature is
/// compared.
bool jagged(const Run& run);

/// Every run, as comma-separated values.
std::string csv(std::span<const Run> runs);

/// The runs as tables in Markdown.
std::string tables(std::span<const Run> runs);
/// Three rows for each mesh: the defaults, and the same drawings with the paper's potential,
/// without and with its relaxation; then their times. Meshes without runs of the paper's potential
/// are left out.
std::string side_by_side(std::span<const Run> defaults, std::span<const Run> paper,
                         std::span<const Run> relaxed);
std::string tables(std::span<const Sweep> sweeps);
std::string tables(std::span<const Subdivision> subdivisions);

}  // namespace talweg::quality
