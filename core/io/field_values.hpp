// A field file holds a number for each vertex, and is read by its extension.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace talweg {

/// Reads numbers, in the order of the file's vertices or faces. By the extension, in upper or lower
/// case:
///
/// - `.gii` (`.shape.gii`, `.func.gii`): the first array with one number per vertex.
/// - `.curv`, `.thickness`, `.sulc`, `.area`, `.volume` of FreeSurfer, and every file that begins
///   with the magic number FFFFFF of its new format (`lh.area.pial`).
/// - `.dpv`: FreeSurfer's text with number, position and value. `.npy`: NumPy's array.
/// - Others: numbers separated by blanks or ends of lines.
///
/// The number of values is not checked here. Sources: "FreeSurfer file formats" (G. Wideman);
/// nibabel.freesurfer.io reads and writes the same. Throws Error(kBadFile) with one sentence that
/// names the file, the place and what was expected. O(bytes).
std::vector<double> read_field_values(const std::filesystem::path& path);
std::vector<double> read_field_values(const std::filesystem::path& path, std::string_view bytes);

}  // namespace talweg
