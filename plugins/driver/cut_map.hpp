// A cut map gives, as JSON, the origins of the vertices and faces of cut meshes.
#pragma once

#include <span>
#include <string>

#include "talweg/core/cutting/mesh_parts.hpp"

namespace talweg::driver {

/// The map of parts that are written to the files of these names (docs/cutting.md).
std::string cut_map_json(std::span<const PartOrigins> parts, std::span<const std::string> files);

}  // namespace talweg::driver
