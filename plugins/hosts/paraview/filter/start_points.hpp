// Points on a mesh that a drawing begins with.
#pragma once

#include <array>
#include <vector>

class vtkPolyData;

namespace talweg::paraview {

/// Three points on the largest connected part of the mesh, spread along its longer side as it is
/// seen in this direction, nearest to the viewer. Without a direction (0) it is seen along the
/// shortest side of its box. Empty if the mesh has no faces, or so few that points would coincide.
std::vector<std::array<double, 3>> start_points(vtkPolyData& mesh,
                                                const std::array<double, 3>& direction);

}  // namespace talweg::paraview
