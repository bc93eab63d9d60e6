// Copies ParaView's arrays to a mesh that a plugin made, by the origin of its elements. All types
// of arrays are copied, texts too.
#pragma once

#include <vector>

#include <vtkType.h>

#include "talweg/plugin/talweg_host.hpp"

class vtkDataSetAttributes;

namespace talweg::paraview {

/// At new points real numbers are interpolated between the corners, normals are scaled to length 1,
/// and colours (3 or 4 components of one byte) are rounded. Other whole numbers, texts, and arrays
/// with "label" in their names are copied from the nearest corner. Points without an origin get 0,
/// or white.
void carry_points(vtkDataSetAttributes& from, const host::Origin& origin, vtkDataSetAttributes& to);

/// `sources` has the old cell that each new cell is a part of; -1: the cell has no origin, and gets
/// 0, or white.
void carry_cells(vtkDataSetAttributes& from, const std::vector<vtkIdType>& sources,
                 vtkDataSetAttributes& to);

}  // namespace talweg::paraview
