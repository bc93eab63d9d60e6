// Voronoi labels divide a mesh at random into connected regions.
#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <random>
#include <tuple>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::test {

/// The label of a face is the number, from 0, of the nearest of `count` random faces, by paths
/// through the centers of faces. Each region is connected; components without such a face get -1.
inline std::vector<std::int64_t> voronoi_labels(const SurfaceMesh& mesh, std::size_t count,
                                                unsigned seed) {
  const Surface& surface = mesh.surface();
  std::vector<Point> middle;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto c = surface.corners(FaceId{f});
    middle.emplace_back((mesh.point(c[0]) + mesh.point(c[1]) + mesh.point(c[2])) / 3);
  }
  std::vector<std::int64_t> labels(middle.size(), -1);
  using Entry = std::tuple<double, std::size_t, std::int64_t>;  // distance, face, label
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::mt19937 random(seed);
  for (std::size_t k = 0; k < count; ++k) {
    queue.emplace(0, random() % middle.size(), static_cast<std::int64_t>(k));
  }
  while (!queue.empty()) {
    const auto [distance, face, label] = queue.top();
    queue.pop();
    if (labels[face] != -1) continue;
    labels[face] = label;
    HalfedgeId h = surface.halfedge(FaceId{face});
    for (int side = 0; side < 3; ++side, h = surface.next(h)) {
      if (!surface.has_face(twin(h))) continue;
      const std::size_t other = surface.face(twin(h)).index();
      if (labels[other] == -1) {
        queue.emplace(distance + (middle[face] - middle[other]).norm(), other, label);
      }
    }
  }
  return labels;
}

/// Labels of vertices: each vertex gets the label of its first face.
inline std::vector<std::int64_t> on_vertices(const Surface& surface,
                                             const std::vector<std::int64_t>& of_faces) {
  std::vector<std::int64_t> labels(surface.vertex_count(), -1);
  for (std::size_t f = surface.face_count(); f-- > 0;) {
    for (const VertexId v : surface.corners(FaceId{f})) labels[v.index()] = of_faces[f];
  }
  return labels;
}

}  // namespace talweg::test
