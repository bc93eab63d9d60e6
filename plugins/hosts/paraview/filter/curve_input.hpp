// A curve input is a drawing as ParaView's users make it: lines, points, lists of vertex numbers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "talweg/plugin/talweg_host.hpp"

class vtkDataObject;
class vtkDataSet;

namespace talweg::paraview {

/// The data set itself, or those that a composite one has.
std::vector<vtkDataSet*> data_sets_of(vtkDataObject& input);

/// Each line of the data set, or of each block, is a curve, closed if it ends where it begins;
/// segments are joined. Without lines all points in their order are one open curve. A point array
/// `pin` says by what is not 0 which points stay, and a point array `exact` which are way-points
/// (talweg_way_points.h). With the name of a point array the curves are of vertices, its values,
/// instead of positions. Throws std::runtime_error for an array that is not there or holds no
/// vertex numbers.
std::vector<host::Curve> curves_of(vtkDataObject& input, const std::string& vertex_array);

/// A curve of vertices, closed if the first is repeated at the end.
host::Curve curve_through(std::vector<std::uint32_t> vertices);

}  // namespace talweg::paraview
