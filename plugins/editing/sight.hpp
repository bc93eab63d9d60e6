// Sight finds the point of a mesh under the mouse, and the points of a drawing that the mesh hides.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mesh_arrays.hpp"
#include "vectors.hpp"

namespace talweg::editing {

/// A tree of bounding boxes of a mesh's triangles. The tree is immutable, so any number of threads
/// may use it.
class Sight {
 public:
  /// O(n log n): about 0.3 s at a million triangles.
  explicit Sight(std::shared_ptr<const MeshArrays> mesh);

  /// The first point of the mesh on the ray from `from` in the direction `way`, on either side of a
  /// triangle; none if the ray meets no triangle. O(log n) as a rule.
  [[nodiscard]] std::optional<Point> first(const Vector& from, const Vector& way) const;

  /// Whether the mesh hides a point from an eye at `from` (mesh units; for a parallel projection, a
  /// place far out along the line of sight). Triangles that touch the point do not hide it. Throws
  /// Error if the mesh has no such face.
  [[nodiscard]] bool is_hidden(const Point& point, const Vector& from) const;

 private:
  struct Box {
    Vector least, most;
    std::uint32_t begin, end;  // the range of its triangles in order_
    std::uint32_t next = 0;    // the index in boxes_ after all boxes inside this box
  };

  void split(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& middles);
  [[nodiscard]] Box box_of(std::uint32_t begin, std::uint32_t end) const;
  template <class Met>
  void meet(const Vector& from, const Vector& way, double most, const Met& met) const;

  std::shared_ptr<const MeshArrays> mesh_;
  std::vector<std::uint32_t> order_;  // triangles; the triangles of a box are a range
  std::vector<Box> boxes_;            // a box comes before the boxes inside it
};

}  // namespace talweg::editing
