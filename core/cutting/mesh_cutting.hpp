// Cutting makes curves edges of the mesh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct CutOptions {
  /// Points that lie within this fraction of an edge (in barycentrics) of a vertex, of an edge or
  /// of each other are merged, so new edges on an old edge are no shorter than this fraction of it.
  /// [1e-11, 1e-2].
  double merge = 1e-6;
  void validate() const;  ///< throws Error(kBadUsage)
};

/// A mesh with curves as chains of edges; its surface is exactly that of the old mesh.
struct CutMesh {
  MeshLists lists;                        ///< the old vertices keep their numbers, new ones follow
  std::vector<SurfacePoint> vertex_from;  ///< where each vertex lies on the old mesh
  std::vector<std::uint32_t> face_from;   ///< the old face that each face is part of
  struct Chain {
    bool closed = false;
    std::vector<std::uint32_t> vertices;  ///< each is joined to the next by an edge
  };
  std::vector<Chain> chains;  ///< one per curve
  std::size_t new_vertices = 0;
  std::size_t crossings = 0;  ///< vertices that were made where curves cross
  std::size_t merged = 0;     ///< points of the curves that were moved onto a vertex or an edge
  double largest_move = 0;    ///< largest move of such a point, mesh units
  std::size_t cut_faces = 0;  ///< old faces that were divided
};

/// Adds vertices on edges and inside faces where the curves run, and divides the faces they run
/// through (constrained Delaunay triangulations, decided exactly in integer barycentrics). No old
/// vertex moves. Curves may pass vertices, run along edges and the boundary, touch and cross
/// themselves and each other; successive points at one place become one.
/// O(vertices + faces + what the curves touch). Throws Error(kBadCurve) naming curve and point
/// where two neighbours have no common face, and Cancelled.
CutMesh cut_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                  const CutOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
