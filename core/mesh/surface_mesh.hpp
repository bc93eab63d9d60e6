// A surface mesh is a checked mesh: connectivity, edge lengths and positions.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A checked mesh in 3D. Immutable once opened, so many threads may read it.
class SurfaceMesh {
 public:
  /// Checks the lists and builds the surface. Edge lengths are the 3D distances, except that an
  /// edge of length 0 gets 1e-12 of the longest side of its faces. O(faces log degree). Throws
  /// Error(kBadMesh) with one sentence that names the first defect and the number of defects: empty
  /// mesh, index out of range, non-finite coordinate, face with a repeated vertex, duplicate face,
  /// edge with more than two faces, inconsistent orientation, bow-tie vertex.
  static SurfaceMesh open(const MeshLists& lists);
  /// Moves the points instead of copying them.
  static SurfaceMesh open(MeshLists&& lists);
  /// This mesh with new vertex positions. Throws Error(kBadUsage) if the triangles of the lists
  /// differ from this mesh, and Error(kBadMesh) as open() does. O(mesh), without building
  /// connectivity.
  [[nodiscard]] SurfaceMesh moved(MeshLists&& lists) const;
  /// This mesh with one new point per vertex. The points are not checked: each must be finite.
  [[nodiscard]] SurfaceMesh moved(std::vector<Point>&& points) const;

  [[nodiscard]] const Surface& surface() const {
    return surface_;
  }  ///< connectivity and edge lengths
  [[nodiscard]] std::span<const Point> points() const { return points_; }  ///< one per vertex
  [[nodiscard]] const Point& point(VertexId v) const { return points_[v.index()]; }
  [[nodiscard]] double mean_edge_length() const { return mean_edge_length_; }  ///< h

  /// The point's position in space.
  [[nodiscard]] Point position(const SurfacePoint& point) const;

 private:
  void measure();

  Surface surface_;
  std::vector<Point> points_;
  double mean_edge_length_ = 0;
};

/// The positions of a curve's points, in order.
std::vector<Point> positions_of(const SurfaceMesh& mesh, const SurfaceCurve& curve);

}  // namespace talweg
