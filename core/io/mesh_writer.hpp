// The mesh writer writes meshes to files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// A curve's edge that is written to a file.
struct TaggedEdge {
  std::uint32_t from = 0, to = 0;  ///< vertices
  std::uint32_t curve = 0;
};

/// Writes OBJ, OFF (text, shortest digits that read back exactly), PLY (binary, little-endian,
/// `double`), STL (binary, `float`: no ids, and coordinates are rounded), VTK (legacy, binary) or
/// VTP (raw), both `double`, by the extension. The space of the coordinates is noted as read_mesh()
/// finds it (OFF has no place for it). The file is either unchanged or complete: a
/// new file is written beside it and renamed. Throws Error(kBadFile) naming path and reason;
/// Error(kBadMesh) when a face refers to a vertex that does not exist.
void write_mesh(const std::filesystem::path& path, const MeshLists& lists);

/// Writes attributes and edges, too. PLY holds all columns of vertices and faces in their types,
/// texture coordinates of corners (list texcoord), normals of corners if each vertex has only one
/// normal, and edges (element edge: vertex1, vertex2, curve). OBJ holds the colours, normals and
/// texture coordinates of vertices, all attributes of corners, names of faces, and edges (l). VTK
/// and VTP hold all columns of vertices and faces (columns that belong together form one array) and
/// edges (as lines before the faces, with their curve in the array curve). OFF and STL hold neither
/// attributes nor edges. Returns descriptions of the parts that the format does not hold. With
/// `outlines` the faces of the outlines are written in place of the triangles, each with the
/// attributes of the triangle of its first corner. Throws Error(kBadUsage) if the number of
/// attributes is not the number of elements, an outline has a corner that does not exist, or
/// outlines are given for STL, VTK or VTP.
std::vector<std::string> write_mesh(const std::filesystem::path& path, const MeshLists& lists,
                                    const MeshAttributes& attributes,
                                    std::span<const TaggedEdge> edges = {},
                                    const FaceOutlines* outlines = nullptr);

/// A file in memory.
struct MeshBytes {
  std::string bytes;
  std::vector<std::string> left_out;  ///< descriptions of the parts that the format does not hold
};
/// The bytes that write_mesh() would write to a file of this name. Throws as it does.
MeshBytes mesh_bytes(const std::filesystem::path& name, const MeshLists& lists,
                     const MeshAttributes& attributes = {}, std::span<const TaggedEdge> edges = {},
                     const FaceOutlines* outlines = nullptr);
/// Throws as write_mesh() does if the name's extension is not the extension of a mesh format that
/// is written.
void check_mesh_name(const std::filesystem::path& name);

}  // namespace talweg
