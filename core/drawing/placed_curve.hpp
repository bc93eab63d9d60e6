// A placed curve has the lists that other programs take: faces, barycentrics, positions.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The places of a curve's points on the mesh and in space; one entry per point in each list.
struct PlacedCurve {
  bool closed = false;             ///< the first point is not repeated
  std::vector<VertexId> vertices;  ///< invalid where the point is at no vertex
  /// A face that contains the point and the next one (the face of smallest id; for an open curve's
  /// last point, the point before), with barycentrics in the order of Surface::corners().
  std::vector<FaceCoordinates> faces;
  std::vector<Point> positions;  ///< mesh units
  /// The marks of the points (point_marks.hpp); empty if no point has a mark.
  std::vector<double> exact;
  std::vector<std::size_t> pins;  ///< indices of points that must stay, ascending
  /// The corners of the faces, and the number of the mesh's vertices; empty and 0 where the mesh is
  /// not known.
  std::vector<std::array<VertexId, 3>> corners;
  std::size_t vertex_count = 0;
  std::vector<Point> normals;  ///< of the surface (surface_normals.hpp), or none
};

/// Places a curve. From the faces and barycentrics snap() makes the same points again, bit for bit.
/// Throws Error(kBadCurve) naming the curve by `number` when it has fewer than two points, or a
/// point and the next lie in no common face. O(points · degree).
PlacedCurve place(const SurfaceMesh& mesh, const SurfaceCurve& curve, std::size_t number = 0);

}  // namespace talweg
