// A cut plan lists the changes of a cut by number: new vertices, divided faces and chains of edges.
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
  /// A fraction of an edge, in barycentric coordinates: points this near to a vertex, an edge or
  /// each other are merged. New edges on an old edge are not shorter than this fraction of it.
  /// [1e-11, 1e-2].
  double merge = 1e-6;
  /// A distance, mesh units, >= 0: points this near are merged, too. For meshes of single
  /// precision, whose coordinates cannot distinguish nearer points.
  double resolution = 0;
  void validate() const;  ///< throws Error(kBadUsage)
};

/// A curve as a chain of edges.
struct CutChain {
  bool closed = false;
  std::vector<std::uint32_t> vertices;  ///< neighbours in the list share an edge
};

/// Statistics of a cut.
struct CutNumbers {
  std::size_t new_vertices = 0;
  std::size_t crossings = 0;  ///< new vertices at crossings of curves
  std::size_t merged = 0;     ///< curve points that were moved onto a vertex or an edge
  double largest_move = 0;    ///< largest move of a merged point, mesh units
  std::size_t cut_faces = 0;  ///< old faces that were divided
};

/// New vertices are numbered after the old vertices.
struct CutPlan : CutNumbers {
  std::size_t old_vertices = 0;
  std::vector<SurfacePoint> vertex_from;  ///< the place of each new vertex
  std::vector<Point> points;              ///< the new vertices' positions
  std::vector<std::uint32_t> faces;       ///< old faces to divide, ascending
  std::vector<std::size_t> first;         ///< index of each face's first triangle; then the end
  std::vector<Triangle> triangles;        ///< of all divided faces, at least two per face
  std::vector<CutChain> chains;           ///< one per curve

  /// The triangles of faces[k], with its orientation.
  [[nodiscard]] std::span<const Triangle> parts(std::size_t k) const {
    return std::span(triangles).subspan(first[k], first[k + 1] - first[k]);
  }
};

/// Throws Error(kBadCurve) with the first point on an element that the surface does not have: the
/// curve belongs to another mesh.
void check_on(const Surface& surface, std::span<const SurfaceCurve> curves);

/// Plans the changes of cut_along(), with its errors. O(elements near the curves) for any size of
/// mesh. Throws Cancelled (stage "cut", up to 0.7).
CutPlan plan_cut(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                 const CutOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
