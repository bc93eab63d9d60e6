// Places curves of files on the mesh, so that the library can measure their turning.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/measure/turning_windows.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::picture {

/// The curvature along curves, in windows of half an edge length.
struct CurveTurning {
  double edge = 0;                                ///< h0 near the first curve, mesh units
  std::vector<std::vector<CurvatureStep>> steps;  ///< of every curve
};

/// A mesh that is not a surface is repaired first; the curves have the indices of `lists`. `curves`
/// must not be empty. Throws as snap(), SurfaceMesh::open() and repair() do.
CurveTurning turning_of(const MeshLists& lists, std::span<const CurveInput> curves);

}  // namespace talweg::picture
