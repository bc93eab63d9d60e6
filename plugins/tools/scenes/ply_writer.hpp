// Writes meshes as PLY files.
#pragma once

#include <filesystem>
#include <string>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::scenes {

/// The bytes of a binary little-endian PLY file with single-precision coordinates.
std::string ply_bytes(const MeshLists& mesh);

/// Writes the bytes. Throws Error(kBadFile) when the file cannot be written.
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

}  // namespace talweg::scenes
