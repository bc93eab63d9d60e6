// The mesh reader reads meshes from files as they are.
#pragma once

#include <filesystem>
#include <string_view>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Reads OBJ, OFF (text), PLY (text, binary of both byte orders), STL (text, binary) or OM, by the
/// file's extension. Nothing is dropped, duplicated or reordered: vertex and face ids are the
/// file's, coordinates are read as doubles. Polygons are triangulated inside themselves, convex
/// ones as fans from their first corner, and counted (triangulate_polygons()). STL has no vertex
/// ids: corners at exactly equal positions become one vertex, numbered by first appearance.
///
/// The space of the coordinates is read where 3D Slicer notes it, as SPACE=LPS or SPACE=RAS: in
/// comments of OBJ (before anything else) and PLY, in the first line or the header of STL.
///
/// Defects of the surface are accepted (see inspect()), but defects of the file are not. Throws
/// Error(kBadFile) with the file's name and, if there is one, the line, vertex or face, when the
/// file cannot be opened or is empty, its extension is unknown, it ends too early or continues
/// after its end, a number cannot be read or (in text) is not finite, a face has fewer than three
/// corners, or an index is out of range. Binary files may hold non-finite coordinates; inspect()
/// reports those.
///
/// The readers are our own because OpenMesh's drop what does not fit its halfedges, use `float` in
/// places, and do not notice a truncated file.
MeshLists read_mesh(const std::filesystem::path& path);

/// Reads from a file's bytes in memory; the path gives the extension and the name in errors.
MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes);

/// Also reads all attributes of vertices, faces and corners from a PLY or OBJ file. Attributes that
/// are not read, and those of other formats, are named in `left_out`. Also throws Error(kBadFile)
/// where an attribute is not a number (nan and inf count as numbers), or an OBJ face names a
/// texture coordinate or normal that does not exist. If an element has more than 64 properties, the
/// rest is left out.
MeshLists read_mesh(const std::filesystem::path& path, MeshAttributes& attributes);
MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes,
                    MeshAttributes& attributes);

}  // namespace talweg
