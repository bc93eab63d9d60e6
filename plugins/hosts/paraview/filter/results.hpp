// Converts the results of a plugin to ParaView's data.
#pragma once

#include <string>

#include "mesh_input.hpp"
#include "talweg/plugin/talweg_host.hpp"

class vtkPolyData;

namespace talweg::paraview {

/// A polyline per curve, a closed one with its first point repeated; points in double precision.
/// Point arrays: face, barycentric (3), vertex (-1: at none), arc_length (from the curve's first
/// point), the fields (deviation, turning), and the arrays of the mesh: point arrays interpolated
/// in the face, cell arrays copied from the face. No array is active, so that curves have a colour
/// of their own. Cell array: curve, the number of each curve. Field data: the report for all
/// curves.
void give(const host::Results& results, const MeshInput& mesh, vtkPolyData& out);

/// The text of a panel on the last run: length, deviation, slack and turning, a line each.
std::string outcome(const host::Results& results);

/// One line on the run, for ParaView's output messages.
std::string summary(const host::Results& results);

}  // namespace talweg::paraview
