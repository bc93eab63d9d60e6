// The mesh reader reads meshes from files as they are.
#pragma once

#include <filesystem>
#include <string_view>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

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

/// The same, with all that a PLY or OBJ file says of vertices, faces and corners; what is not read,
/// and what the other formats hold, is named in `left_out`. Also throws Error(kBadFile) where a
/// number of these is none (nan and inf are numbers here), or an OBJ face names a texture
/// coordinate or normal that is not there. Of more than 64 properties of an element the rest is
/// left out.
MeshLists read_mesh(const std::filesystem::path& path, MeshAttributes& attributes);
MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes,
                    MeshAttributes& attributes);

}  // namespace talweg
