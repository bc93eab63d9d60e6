// Reading meshes from files as they are.
#pragma once

#include <filesystem>
#include <string_view>

#include "talweg/core/mesh_lists.hpp"

namespace talweg {

/// Reads OBJ, OFF (text), PLY (text, binary of both byte orders), STL (text, binary) or OM, by the
/// file's extension. Nothing is dropped, duplicated or reordered: vertex and face ids are the
/// file's, coordinates are read as doubles. Polygons are fan-triangulated from their first corner
/// and counted. STL has no vertex ids: corners at exactly equal positions become one vertex,
/// numbered by first appearance.
///
/// Defects of the surface pass (see inspect()); defects of the file do not. Throws Error(kBadFile)
/// with the file's name and, where there is one, the line, vertex or face, when the file cannot be
/// opened or is empty, its extension is unknown, it ends too early or goes on after its end, a
/// number cannot be read or (in text) is not finite, a face has fewer than three corners, or an
/// index is out of range. Binary files may hold non-finite coordinates; inspect() reports those.
///
/// The readers are our own, not OpenMesh's: those drop what does not fit their halfedges, go
/// through `float` in places, and do not notice a file that is cut off.
MeshLists read_mesh(const std::filesystem::path& path);

/// The same from a file's bytes in memory; the path gives the extension and the name in errors.
MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes);

}  // namespace talweg
