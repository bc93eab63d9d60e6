// Chooses the first points of a new drawing on a mesh.
#pragma once

#include <array>
#include <vector>

class vtkPolyData;

namespace talweg::paraview {

/// Three points on the largest connected part of the mesh, spread along its longer side in the view
/// from `eye` to `focus`; each is the first point on its ray. If eye and focus are equal, the view
/// is along the shortest side of the mesh's box, from far away. Empty if the mesh has no faces, or
/// is so small that points would coincide.
std::vector<std::array<double, 3>> start_points(vtkPolyData& mesh, const std::array<double, 3>& eye,
                                                const std::array<double, 3>& focus);

}  // namespace talweg::paraview
