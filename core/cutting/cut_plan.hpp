// A cut plan is what a cut changes, by number: new vertices, divided faces and chains of edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct CutOptions {
  /// Points that lie within this fraction of an edge (in barycentrics) of a vertex, of an edge or
  /// of each other are merged, so new edges on an old edge are no shorter than this fraction of it.
  /// [1e-11, 1e-2].
  double merge = 1e-6;
  /// So are points that lie within this distance, in mesh units. >= 0. It is for meshes whose
  /// coordinates are stored in single precision, which cannot tell nearer points apart.
  double resolution = 0;
  void validate() const;  ///< throws Error(kBadUsage)
};

/// A curve as a chain of edges.
struct CutChain {
  bool closed = false;
  std::vector<std::uint32_t> vertices;  ///< each is joined to the next by an edge
};

/// What was done, in numbers.
struct CutNumbers {
  std::size_t new_vertices = 0;
  std::size_t crossings = 0;  ///< vertices that were made where curves cross
  std::size_t merged = 0;     ///< points of the curves that were moved onto a vertex or an edge
  double largest_move = 0;    ///< largest move of such a point, mesh units
  std::size_t cut_faces = 0;  ///< old faces that were divided
};

/// New vertices have the numbers that follow those of the old ones.
struct CutPlan : CutNumbers {
  std::size_t old_vertices = 0;
  std::vector<SurfacePoint> vertex_from;  ///< where each new vertex lies
  std::vector<Point> points;              ///< the new vertices' positions
  std::vector<std::uint32_t> faces;       ///< old faces that are divided, ascending
  std::vector<std::size_t> first;   ///< where the triangles of each begin; at last where they end
  std::vector<Triangle> triangles;  ///< of all divided faces, at least two of each
  std::vector<CutChain> chains;     ///< one per curve

  /// The triangles that faces[k] is divided into, which have its corners and orientation.
  [[nodiscard]] std::span<const Triangle> parts(std::size_t k) const {
    return std::span(triangles).subspan(first[k], first[k + 1] - first[k]);
  }
};

/// Throws Error(kBadCurve) naming a curve's point on an element that the surface does not have, so
/// that the curve is one of another mesh.
void check_on(const Surface& surface, std::span<const SurfaceCurve> curves);

/// Plans what cut_along() does, by its rules and with its errors. O(what the curves touch), however
/// large the mesh is. Throws Cancelled when `progress` (stage "cut", up to 0.7) says so.
CutPlan plan_cut(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                 const CutOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
