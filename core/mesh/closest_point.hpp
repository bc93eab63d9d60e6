// The point of a mesh that is nearest to a position in space.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// A hierarchy of boxes over the triangles of a mesh, along a space-filling curve. Building is
/// O(faces) with about 40 bytes per face; a query is O(log faces) for positions near the mesh.
/// Immutable, so many threads may ask. The mesh must outlive it.
class ClosestPoint {
 public:
  /// Throws Error(kBadMesh) when the mesh has no face.
  explicit ClosestPoint(const SurfaceMesh& mesh);

  struct Result {
    SurfacePoint point;  ///< on a vertex or an edge where it is there to rounding
    FaceId face;         ///< a face that contains it; the smallest of equally near ones
    std::array<double, 3> barycentric{};  ///< in that face, all >= 0, sum 1 up to rounding
    double distance = 0;                  ///< mesh units
  };

  /// The nearest point. Zero-area triangles count as the segments they are.
  /// Throws Error(kBadCurve) when the position is not finite, or too far away to square distances.
  [[nodiscard]] Result nearest(const Point& position) const;

 private:
  struct Box {
    Point low, high;
    [[nodiscard]] double squared_distance(const Point& p) const {
      return ((low - p).cwiseMax(p - high)).cwiseMax(0.0).squaredNorm();
    }
  };
  struct Candidate {
    std::uint32_t face = 0;
    std::array<double, 3> barycentric{};
    double squared_distance = 0;
    bool found = false;
  };

  void sort_faces();
  void make_boxes();
  void visit(std::size_t leaf, const Point& position, Candidate& best) const;

  const SurfaceMesh* mesh_;
  std::vector<std::uint32_t> order_;  // faces along the space-filling curve
  std::size_t leaf_count_ = 1;        // a power of two
  std::size_t leaf_size_ = 1;         // consecutive faces per leaf
  std::vector<Box> boxes_;            // node k has the children 2k and 2k + 1; the root is 1
};

}  // namespace talweg
