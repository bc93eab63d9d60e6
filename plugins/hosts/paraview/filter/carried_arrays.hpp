// Arrays of ParaView are carried to a mesh that a plugin made, by where it comes from. They are of
// every type that ParaView has, texts too.
#pragma once

#include <vector>

#include <vtkType.h>

#include "talweg/plugin/talweg_host.hpp"

class vtkDataSetAttributes;

namespace talweg::paraview {

/// In new points real numbers are between those of the corners, normals have length 1, colours (one
/// byte for each of 3 or 4 components) are rounded; other whole numbers, texts, and arrays with
/// "label" in their names have the nearest corner's. Points from nowhere have 0, or white.
void carry_points(vtkDataSetAttributes& from, const host::Origin& origin, vtkDataSetAttributes& to);

/// `sources`: the cell that each new one is a part of; -1: it comes from nowhere, and has 0, or
/// white.
void carry_cells(vtkDataSetAttributes& from, const std::vector<vtkIdType>& sources,
                 vtkDataSetAttributes& to);

}  // namespace talweg::paraview
