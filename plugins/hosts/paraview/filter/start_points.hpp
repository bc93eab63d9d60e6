// Points on a mesh that a drawing begins with.
#pragma once

#include <array>
#include <vector>

class vtkPolyData;

namespace talweg::paraview {

/// Three points on the largest connected part of the mesh, spread along its longer side as an eye
/// sees it that looks at `focus`: the first points that it sees there. If both are one place, the
/// mesh is seen along the shortest side of its box, from far away. Empty if the mesh has no faces,
/// or so few that points would coincide.
std::vector<std::array<double, 3>> start_points(vtkPolyData& mesh, const std::array<double, 3>& eye,
                                                const std::array<double, 3>& focus);

}  // namespace talweg::paraview
