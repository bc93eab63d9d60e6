// Writing meshes to files.
#pragma once

#include <filesystem>

#include "talweg/core/mesh_lists.hpp"

namespace talweg {

/// Writes OBJ, OFF (text, shortest digits that read back exactly), PLY (binary, little-endian,
/// `double`) or STL (binary, `float`: no ids, and coordinates are rounded), by the extension.
/// The file is as it was or complete: it is written beside and renamed.
/// Throws Error(kBadFile) naming path and reason; Error(kBadMesh) when a face refers to a vertex
/// that does not exist.
void write_mesh(const std::filesystem::path& path, const MeshLists& lists);

}  // namespace talweg
