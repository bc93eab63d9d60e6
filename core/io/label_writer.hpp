// Label files are written by their extension.
#pragma once

#include <filesystem>
#include <string>

#include "talweg/core/io/label_file.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Labels to be written: one per vertex or face of a mesh, in its order.
struct LabelOutput : LabelFile {
  bool of_faces = false;
};

/// The bytes of a label file. The format follows from the name's extension, in upper or lower case:
///
/// - `.txt`, `.labels`, or none: a label per line.
/// - `.csv`: a header (`vertex,label` or `face,label`) and a line for each.
/// - `.npy`: 64-bit whole numbers, little-endian.
/// - `.ply`, `.vtk`, `.vtp`: the mesh with the labels as `label` of its faces or vertices; PLY also
///   has the mesh's attributes, where `label` is replaced.
/// - `.annot` of FreeSurfer (version 2), vertices only: the number in the color table is the label,
///   from 0 to 16,777,215; -1 has no color. Labels without a color, or with the color of another
///   label, get a new color.
/// - `.gii` (`.label.gii`), vertices only: ASCII, with a label table; labels have 32 bits.
/// - `.label` of FreeSurfer, vertices only: the vertices of the only label that is not 0 or -1.
/// - `.dpv` of FreeSurfer, vertices only.
///
/// `.annot` and `.gii` hold names and colors, also of labels that no vertex has. Throws
/// Error(kBadFile) as check_label_name() and check_label_kind() do, and for labels that the format
/// cannot hold. O(bytes), times a logarithm for names.
std::string label_bytes(const std::filesystem::path& name, const LabelOutput& output,
                        const MeshLists& mesh, const MeshAttributes& attributes = {});

/// Throws Error(kBadFile) that lists the formats if none has the name's extension.
void check_label_name(const std::filesystem::path& name);
/// Throws Error(kBadFile) for labels of faces if the format holds only labels of vertices.
void check_label_kind(const std::filesystem::path& name, bool of_faces);
/// Whether the format is a list without a mesh: `.txt`, `.labels`, `.csv`, `.npy`.
bool is_label_list(const std::filesystem::path& name);
/// Throws Error(kBadFile) unless is_label_list().
void check_label_list_name(const std::filesystem::path& name);

}  // namespace talweg
