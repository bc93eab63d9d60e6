// Meshes that a plugin made, as ParaView's data.
#pragma once

#include <vector>

#include "mesh_input.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::paraview {

/// The triangles with all arrays of the mesh that they were made of, and the cell array
/// origin_cell: the cell of that mesh which each is a part of, -1 in lids.
void give(const host::Mesh& mesh, const host::Origin& origin, const MeshInput& from,
          vtkPolyData& out);

/// The curves' chains of edges on the meshes of a run, as lines; the cell array curve says which
/// curve each belongs to. Where a seam was opened the first of the vertices there counts, and a
/// curve that lies partly in no mesh has a line for each stretch of it.
void give_chains(const std::vector<host::Mesh>& meshes, const std::vector<host::Origin>& origins,
                 vtkPolyData& out);

}  // namespace talweg::paraview
