// A click file is a list of clicked points, in the order of the clicks.
#pragma once

#include <filesystem>
#include <string_view>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/space/coordinate_frame.hpp"

namespace talweg {

/// Reads the points of 3D Slicer's point lists and curves: `.fcsv`, or `.mrk.json` with one markup
/// of type Fiducial, PointList, Line, Curve or ClosedCurve. Positions are converted to the frame of
/// the mesh, as by read_curves(). Only a ClosedCurve gives a closed result. CurveInput::notes has
/// sentences on conversions and on points left out. Throws Error(kBadFile) with one sentence that
/// names the file, the place and what was expected.
CurveInput read_clicks(const std::filesystem::path& path, const CoordinateFrame& frame = {});
/// Reads from a file's bytes in memory; the path gives the extension and the name in errors.
CurveInput read_clicks(const std::filesystem::path& path, std::string_view bytes,
                       const CoordinateFrame& frame = {});

}  // namespace talweg
