// The mesh reader reads the meshes of files, unchanged and unrepaired.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Reads OBJ, OFF, PLY, STL (text, binary of both byte orders), OM, VTK (legacy: polydata, and the
/// faces of an unstructured grid), VTP, MSH (Gmsh, 2 and 4.1), glTF, GLB, 3MF, GIFTI and
/// FreeSurfer's surfaces, by the file's extension. No part of the surface is dropped, duplicated or
/// reordered: vertex and face ids are the file's, coordinates are read as doubles. Polygons are
/// triangulated by inner diagonals, convex polygons as fans from their first corner, and counted
/// (triangulate_polygons()). STL has no vertex ids: corners at exactly equal positions become one
/// vertex, numbered by first appearance.
///
/// The space of the coordinates is read from 3D Slicer's note SPACE=LPS or SPACE=RAS: in comments
/// of OBJ (before anything else) and PLY, in the first line or the header of STL, in the title of
/// VTK and the field data of VTP.
///
/// Defects of the surface are accepted (see inspect()), defects of the file are errors. Throws
/// Error(kBadFile) with the file's name and, if there is one, the line, vertex or face, when the
/// file cannot be opened or is empty, its extension is unknown (with advice on converting related
/// formats), the file ends too early or continues after its end (bytes after a binary STL are only
/// reported in `notes`), a number cannot be read, a face has fewer than three corners, or an index
/// is out of range. In the text of OBJ, OFF and PLY a vertex whose coordinates are not finite is
/// kept if no face uses it, and otherwise an error; in STL always an error. Other files may hold
/// any coordinates; inspect() reports those that are not finite.
///
/// glTF and 3MF: the meshes of the default scene, or of the build, are transformed and appended one
/// after the other, each with all its vertices in their order. Buffers of a .gltf are read from
/// files beside the file. MSH: nodes are vertices in the file's order, whatever their numbers.
/// `notes` names contents that are not a surface (lines, volumes).
///
/// Talweg has its own readers because the readers of OpenMesh drop faces that do not fit its
/// halfedges, use `float` in places, and do not notice a truncated file.
MeshLists read_mesh(const std::filesystem::path& path);

/// The extensions of the formats that read_mesh() reads: ".obj, .off, ... or .3mf".
std::string readable_meshes();

/// Reads from a file's bytes in memory; the path gives the extension and the name in errors.
MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes);

/// Also reads all attributes of vertices, faces and corners from a PLY or OBJ file; all arrays of
/// numbers of a VTK or VTP file (an array of several components becomes as many columns: NAME_0,
/// ...; normals, colours and texture coordinates get the names of PLY); the physical groups of a
/// MSH file (face column physical, and their names as names of OBJ groups); normals, colours,
/// texture coordinates and names of a glTF file; names of a 3MF file. Attributes that are not read,
/// and attributes of other formats, are named in `left_out`. Also throws Error(kBadFile) if an
/// attribute is not a number (nan and inf count as numbers), or an OBJ face names a texture
/// coordinate or normal that does not exist. If an element has more than 64 properties, the rest is
/// left out.
MeshLists read_mesh(const std::filesystem::path& path, MeshAttributes& attributes);
MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes,
                    MeshAttributes& attributes);

}  // namespace talweg
