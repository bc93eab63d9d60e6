// Mesh numbers are the numbers that a cut must not change.
#pragma once

#include <cstdint>

#include "core/small_meshes.hpp"

namespace talweg::test {

inline double area(const MeshLists& lists) {
  double sum = 0;
  for (const auto& [a, b, c] : lists.triangles) {
    sum += (lists.points[b] - lists.points[a]).cross(lists.points[c] - lists.points[a]).norm() / 2;
  }
  return sum;
}

inline double volume(const MeshLists& lists) {
  double sum = 0;
  for (const auto& [a, b, c] : lists.triangles) {
    sum += lists.points[a].dot(lists.points[b].cross(lists.points[c])) / 6;
  }
  return sum;
}

/// The Euler characteristic.
inline std::int64_t euler(const Surface& surface) {
  return static_cast<std::int64_t>(surface.vertex_count()) -
         static_cast<std::int64_t>(surface.edge_count()) +
         static_cast<std::int64_t>(surface.face_count());
}
inline std::int64_t euler(const MeshLists& lists) { return euler(surface_of_lists(lists)); }

}  // namespace talweg::test
