// The closest point of a mesh is its point nearest to a position in space.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/box_tree.hpp"

namespace talweg {

/// The distance of a position to a face, mesh units. O(1).
double distance_to_face(const SurfaceMesh& mesh, FaceId face, const Point& position);

/// Building takes O(faces) time and about 25 bytes per face; a query is O(log faces) for positions
/// near the mesh. The object is immutable, so many threads may use it. The mesh must outlive it.
class ClosestPoint {
 public:
  /// Throws Error(kBadMesh) when the mesh has no face.
  explicit ClosestPoint(const SurfaceMesh& mesh);

  struct Result {
    SurfacePoint point;  ///< at a vertex or on an edge if it is there up to rounding
    FaceId face;         ///< the face with the point; the smallest of equally near faces
    std::array<double, 3> barycentric{};  ///< in `face`, all >= 0, sum 1 up to rounding
    double distance = 0;                  ///< mesh units
  };

  /// The nearest point. Zero-area triangles count as segments.
  /// Throws Error(kBadCurve) when the position is not finite, or too far away to square distances.
  [[nodiscard]] Result nearest(const Point& position) const;
  /// The nearest point of every part of the surface within `reach` (mesh units) of the position, by
  /// distance, at most `most` points. A point is a local minimum: no face that shares a vertex with
  /// its face is nearer. If no face is within reach, the result is nearest(). Throws as nearest()
  /// does.
  [[nodiscard]] std::vector<Result> on_sheets(const Point& position, double reach,
                                              std::size_t most) const;

 private:
  const SurfaceMesh* mesh_;
  BoxTree tree_;  // of faces
};

}  // namespace talweg
