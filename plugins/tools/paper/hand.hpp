// Curves as an unsteady hand paints them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::paper {

/// A trembling open line along mesh edges with this many vertices, over large parts of the first
/// vertex's component: it leads from one far end to the next, and points are moved sideways by a
/// few edges. The line is shorter if the mesh has no room. Deterministic. Factors the heat solver.
/// Throws Error(kBadCurve) if there is no room at all.
SurfaceCurve tour(const OpenedMesh& mesh, std::size_t vertices, std::uint64_t seed);

/// A curve along mesh edges through the vertices nearest to these places.
/// Throws Error(kBadCurve) as EdgeDijkstra::draw.
SurfaceCurve painted(const OpenedMesh& mesh, const MeshLists& lists,
                     const std::vector<Point>& places, bool closed);

}  // namespace talweg::paper
