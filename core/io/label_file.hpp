// Label files hold a number for each vertex or face, and are read by their extension.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace talweg {

/// Labels as a file gives them, one per face or per vertex of the mesh that they are for.
struct LabelFile {
  std::vector<std::int64_t> labels;
  std::map<std::int64_t, std::string> names;  ///< printable; of labels that have one
};

struct LabelFileOptions {
  /// Of a PLY or VTK file the property or array; empty: the first of label, labels, segment,
  /// region, class, scalar_label that is there, of faces before of vertices.
  std::string property;
  std::size_t vertex_count = 0;  ///< of the mesh: FreeSurfer's .label lists vertices only
};

/// Reads labels, by extension, in either case:
///
/// - `.annot` of FreeSurfer, one label per vertex: the number of the color table's entry whose
///   color the vertex has, -1 where it has none (0), with the table's names (version 1 and 2). A
///   file without a table gives the colors' numbers themselves.
/// - `.label` of FreeSurfer: 1 for the vertices that are listed, 0 for the others.
/// - `.ply`: a property of the faces or vertices, text or binary; polygons have theirs once for
/// each
///   triangle of their fan.
/// - `.vtk` (legacy, ascii and binary), `.vtp`: an array of one component per cell or point; as
/// many
///   cells as the mesh has faces are expected.
/// - Others: whole numbers separated by blanks or ends of lines.
///
/// How many there are is not checked here. Sources of FreeSurfer's formats: "LabelsClutsAnnotation-
/// Files" in FreeSurfer's wiki; nibabel.freesurfer.io reads and writes the same. Throws
/// Error(kBadFile) with one sentence that names the file, the place and what was expected.
LabelFile read_label_file(const std::filesystem::path& path, const LabelFileOptions& options);
/// The same from a file's bytes in memory; the path gives the extension and the name in errors.
LabelFile read_label_file(const std::filesystem::path& path, std::string_view bytes,
                          const LabelFileOptions& options);

}  // namespace talweg
