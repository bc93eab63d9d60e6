// Sight tells what can be seen of a mesh: what lies under the mouse, and which points of a drawing
// the mesh hides.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mesh_arrays.hpp"
#include "vectors.hpp"

namespace talweg::editing {

/// The triangles of a mesh in a tree of boxes. Immutable, so any number of threads may use it.
class Sight {
 public:
  /// O(n log n): about 0.3 s at a million triangles.
  explicit Sight(std::shared_ptr<const MeshArrays> mesh);

  /// The first point of the mesh on the way from `from` on in the direction `way`; of both sides of
  /// triangles. Nothing if the way meets none. O(log n) as a rule.
  [[nodiscard]] std::optional<Point> first(const Vector& from, const Vector& way) const;

  /// Whether the mesh lies between a point on it and the place from where one looks (mesh units;
  /// for a parallel projection a place far out along the line of sight). Triangles that touch the
  /// point hide nothing. Throws Error for a face that does not exist.
  [[nodiscard]] bool is_hidden(const Point& point, const Vector& from) const;

 private:
  struct Box {
    Vector least, most;
    std::uint32_t begin, end;  // of its triangles in order_
    std::uint32_t next = 0;    // the box after all that are inside this one
  };

  void split(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& middles);
  [[nodiscard]] Box box_of(std::uint32_t begin, std::uint32_t end) const;
  template <class Met>
  void meet(const Vector& from, const Vector& way, double most, const Met& met) const;

  std::shared_ptr<const MeshArrays> mesh_;
  std::vector<std::uint32_t> order_;  // triangles, those of a box side by side
  std::vector<Box> boxes_;            // each before those inside it
};

}  // namespace talweg::editing
