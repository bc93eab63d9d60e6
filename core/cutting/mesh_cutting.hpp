// Cutting turns curves into edges of the mesh.
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

/// A mesh with curves as chains of edges. Its surface equals the surface of the old mesh.
struct CutMesh : CutNumbers {
  MeshLists lists;                        ///< old vertices keep their numbers, new vertices follow
  std::vector<SurfacePoint> vertex_from;  ///< the place of each vertex on the old mesh
  std::vector<std::uint32_t> face_from;   ///< the old face that each face is a part of
  using Chain = CutChain;
  std::vector<Chain> chains;  ///< one per curve
};

/// Adds vertices at the curves' points and crossings, and divides the faces along the curves by
/// constrained Delaunay triangulations, exact in integer barycentric coordinates. Old vertices do
/// not move. Curves may pass vertices, run along edges and the boundary, touch and cross themselves
/// and each other; consecutive points at one place become one. O(vertices + faces + k log k) for k
/// elements near the curves. Throws Error(kBadCurve) with curve and point if two consecutive points
/// share no face, and Cancelled.
CutMesh cut_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                  const CutOptions& options = {}, const Progress& progress = {});
/// Applies a plan for `mesh`. O(vertices + faces). Throws Cancelled.
CutMesh cut_by(const SurfaceMesh& mesh, const CutPlan& plan, const Progress& progress = {});

}  // namespace talweg
