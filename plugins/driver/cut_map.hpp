// A cut map tells where the vertices and faces of cut meshes come from, as JSON.
#pragma once

#include <span>
#include <string>

#include "talweg/core/cutting/mesh_parts.hpp"

namespace talweg::driver {

/// The map of parts that are written to these files (docs/cutting.md).
std::string cut_map_json(std::span<const PartOrigins> parts, std::span<const std::string> files);

}  // namespace talweg::driver
