// Converts meshes that a plugin made to ParaView's data.
#pragma once

#include <vector>

#include "mesh_input.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::paraview {

/// The triangles with all arrays of the original mesh, and the cell array origin_cell: the original
/// cell that each is a part of, -1 in lids.
void give(const host::Mesh& mesh, const host::Origin& origin, const MeshInput& from,
          vtkPolyData& out);

/// The curves' chains of edges on the meshes of a run, as lines; the cell array curve has the
/// curve's number. At an opened seam the first vertex of a place is used. If parts of a
/// curve are in no mesh, each of its other parts is a line.
void give_chains(const std::vector<host::Mesh>& meshes, const std::vector<host::Origin>& origins,
                 vtkPolyData& out);

}  // namespace talweg::paraview
