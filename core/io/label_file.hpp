// Label files hold a number for each vertex or face, and are read by their extension.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace talweg {

/// Red, green, blue and alpha, each from 0 to 1.
using LabelColor = std::array<double, 4>;

/// Labels from a file, one per face or per vertex of a mesh.
struct LabelFile {
  std::vector<std::int64_t> labels;
  std::map<std::int64_t, std::string> names;  ///< names of labels, if they have one; printable
  std::map<std::int64_t, LabelColor> colors;  ///< colors of labels, if they have one
};

struct LabelFileOptions {
  /// The property of a PLY file, the array of a VTK file, the column of a CSV file, or the map of a
  /// GIFTI file. If empty, the first map of a GIFTI file; otherwise the first of label, labels,
  /// segment, region, class, scalar_label that exists, for faces before vertices.
  std::string property;
  std::size_t vertex_count = 0;  ///< of the mesh; FreeSurfer's .label lists vertices only
};

/// Reads labels. The format follows from the extension, in upper or lower case:
///
/// - `.annot` of FreeSurfer, one label per vertex: the number of the color table's entry that has
///   the vertex's color, -1 for vertices without color (0), with the table's names (version 1 and
///   2). If there is no table, the labels are the colors' numbers.
/// - `.label` of FreeSurfer: 1 for the vertices that are listed, 0 for the others.
/// - `.ply`: a property of the faces or vertices, text or binary; a polygon's value is repeated for
///   each triangle of its fan.
/// - `.vtk` (legacy, ascii and binary), `.vtp`: an array of one component per cell or point; the
///   file must have as many cells as the mesh has faces.
/// - `.gii` (`.label.gii`): an array of the intent NIFTI_INTENT_LABEL, with names and colors of the
///   label table; see gifti.hpp.
/// - `.dpv` of FreeSurfer, text: lines `number x y z label`, the numbers counted from 0.
/// - `.csv`, separated by commas, semicolons or tabs: one column, or several with a header. The
///   labels are the column chosen by `property`, or the only column beside the numbers of the
///   vertices or faces (vertex, face, index, id or no name). Each number must come once.
/// - `.npy` of NumPy: see numpy_array.hpp.
/// - Others: whole numbers separated by blanks or ends of lines, also as `1.000e+00`; `#` starts a
///   comment.
///
/// The number of labels is not checked here. Sources of FreeSurfer's formats:
/// "LabelsClutsAnnotationFiles" in FreeSurfer's wiki; nibabel.freesurfer.io reads and writes the
/// same. Throws Error(kBadFile) with one sentence that names the file, the place and what was
/// expected.
LabelFile read_label_file(const std::filesystem::path& path, const LabelFileOptions& options);
/// Reads from a file's bytes in memory; the path gives the extension and the name in errors.
LabelFile read_label_file(const std::filesystem::path& path, std::string_view bytes,
                          const LabelFileOptions& options);

}  // namespace talweg
