// Reads curves from the data sets of ParaView's users: lines, points, or lists of vertex indices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "talweg/plugin/talweg_host.hpp"

class vtkDataObject;
class vtkDataSet;

namespace talweg::paraview {

/// The data set itself, or the leaves of a composite data set.
std::vector<vtkDataSet*> data_sets_of(vtkDataObject& input);

/// Each line of the data set, or of each block, is a curve, closed if it ends at its first point;
/// segments are joined. Without lines all points in their order are one open curve. A value other
/// than 0 in a point array `pin` pins a point; a point array `exact` marks way-points
/// (talweg_way_points.h). `vertex_array` names a point array of vertex indices, which are used
/// instead of positions; empty: none. Throws std::runtime_error if there is no such array, or if it
/// has no vertex indices.
std::vector<host::Curve> curves_of(vtkDataObject& input, const std::string& vertex_array);

/// A curve of vertices, closed if the first is repeated at the end.
host::Curve curve_through(std::vector<std::uint32_t> vertices);

}  // namespace talweg::paraview
