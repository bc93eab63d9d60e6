// Cutting makes curves edges of the mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/cutting/cut_plan.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A mesh with curves as chains of edges; its surface is exactly that of the old mesh.
struct CutMesh : CutNumbers {
  MeshLists lists;                        ///< the old vertices keep their numbers, new ones follow
  std::vector<SurfacePoint> vertex_from;  ///< where each vertex lies on the old mesh
  std::vector<std::uint32_t> face_from;   ///< the old face that each face is part of
  using Chain = CutChain;
  std::vector<Chain> chains;  ///< one per curve
};

/// Adds vertices on edges and inside faces where the curves run, and divides the faces they run
/// through (constrained Delaunay triangulations, decided exactly in integer barycentrics). No old
/// vertex moves. Curves may pass vertices, run along edges and the boundary, touch and cross
/// themselves and each other; successive points at one place become one.
/// O(vertices + faces + what the curves touch). Throws Error(kBadCurve) naming curve and point
/// where two neighbours have no common face, and Cancelled.
CutMesh cut_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                  const CutOptions& options = {}, const Progress& progress = {});
/// The mesh as this plan has it, which must be one for `mesh`. O(vertices + faces). Throws
/// Cancelled.
CutMesh cut_by(const SurfaceMesh& mesh, const CutPlan& plan, const Progress& progress = {});

}  // namespace talweg
