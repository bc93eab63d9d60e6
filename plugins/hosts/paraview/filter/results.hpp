// The results of a plugin become ParaView's data.
#pragma once

#include <string>

#include "talweg/plugin/talweg_host.hpp"

class vtkPolyData;

namespace talweg::paraview {

/// A polyline per curve, a closed one with its first point repeated; points in double precision.
/// Point arrays: face, barycentric (3), vertex (-1: at none), and the fields (deviation,
/// curvature). Cell arrays: the numbers of each curve's report, also those that the report on all
/// has under `group` (borders.0.left). Field data: the report on all together.
void give(const host::Results& results, vtkPolyData& out, const char* group = "");

/// One line on what was done, for ParaView's output messages.
std::string summary(const host::Results& results);

}  // namespace talweg::paraview
