// A space note is how 3D Slicer writes the space of coordinates into comments: SPACE=RAS.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/space/coordinate_frame.hpp"

namespace talweg::formats {

/// The space that a comment names as SPACE=LPS or SPACE=RAS, as 3D Slicer's
/// vtkMRMLModelStorageNode writes and finds it; kNotSaid if it names none of these.
PatientSpace space_in(std::string_view comment);

/// The same for the comments (#) before the first other line of a text.
PatientSpace space_in_comments(std::string_view text);

/// The line of a file's text that says so: `prefix`, "SPACE=RAS" and an end of line. Empty where
/// nothing is said.
std::string space_line(std::string_view prefix, PatientSpace space);

/// The field data of a VTP file that say so, as 3D Slicer writes and finds them: a string array of
/// the codes of the letters and 0. Empty where nothing is said.
std::string space_data(PatientSpace space);

/// Turns x and y of curves of positions where they are in another space than the mesh, and tells
/// the first curve so.
void turn_to(const CoordinateFrame& frame, PatientSpace space, const std::filesystem::path& path,
             std::vector<CurveInput>& curves);

/// A sentence on positions of a file that were turned or scaled; empty where neither was.
std::string conversion(const std::filesystem::path& path, const CoordinateFrame& from,
                       const CoordinateFrame& to);
/// A sentence on `count` of `all` points of a file that have no position.
std::string left_out(const std::filesystem::path& path, std::size_t count, std::size_t all);

}  // namespace talweg::formats
