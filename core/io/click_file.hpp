// A click file holds points that were set one by one, in their order.
#pragma once

#include <filesystem>
#include <string_view>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/space/coordinate_frame.hpp"

namespace talweg {

/// Reads the points of 3D Slicer's point lists and curves: `.fcsv`, or `.mrk.json` with one markup
/// of type Fiducial, PointList, Line, Curve or ClosedCurve. Positions are converted to the frame of
/// the mesh, as read_curves() does. The result is open but for a ClosedCurve; what was converted
/// and left out is in its sentences (CurveInput::told).
/// Throws Error(kBadFile) with one sentence that names the file, the place and what was expected.
CurveInput read_clicks(const std::filesystem::path& path, const CoordinateFrame& frame = {});
/// Reads from a file's bytes in memory; the path gives the extension and the name in errors.
CurveInput read_clicks(const std::filesystem::path& path, std::string_view bytes,
                       const CoordinateFrame& frame = {});

}  // namespace talweg
