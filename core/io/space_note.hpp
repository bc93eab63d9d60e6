// A space note is how 3D Slicer writes the space of coordinates into comments: SPACE=RAS.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/space/coordinate_frame.hpp"

namespace talweg::formats {

/// The space that a comment names as SPACE=LPS or SPACE=RAS, as 3D Slicer's vtkMRMLModelStorageNode
/// writes and finds it; kNotSaid if the comment names neither.
PatientSpace space_in(std::string_view comment);

/// The space that the comments (#) before the first other line of a text name.
PatientSpace space_in_comments(std::string_view text);

/// The line of text that notes a space: `prefix`, "SPACE=RAS" and an end of line. Empty for
/// kNotSaid.
std::string space_line(std::string_view prefix, PatientSpace space);

/// The field data of a VTP file that note a space, as 3D Slicer writes and finds them: a string
/// array of the codes of the letters and 0. Empty for kNotSaid.
std::string space_data(PatientSpace space);

/// Negates x and y of the positions of curves if their space differs from the space of the mesh.
/// The first curve then gets a sentence on the conversion.
void turn_to(const CoordinateFrame& frame, PatientSpace space, const std::filesystem::path& path,
             std::vector<CurveInput>& curves);

/// A sentence on the positions of a file that were turned or scaled; empty if they were not.
std::string conversion(const std::filesystem::path& path, const CoordinateFrame& from,
                       const CoordinateFrame& to);
/// A sentence on `count` of `all` points of a file that have no position.
std::string left_out(const std::filesystem::path& path, std::size_t count, std::size_t all);

}  // namespace talweg::formats
