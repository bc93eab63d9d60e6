// The harness: code around the C++ blocks of the docs.
#pragma once

#undef NDEBUG  // assertions of the blocks count in every build
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/openmesh.hpp"

namespace docs {

constexpr std::size_t kCells = 12;

/// A wavy square of kCells x kCells cells.
template <class Mesh>
Mesh sheet() {
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  Mesh mesh;
  std::vector<OpenMesh::VertexHandle> v;
  for (std::size_t i = 0; i <= kCells; ++i) {
    for (std::size_t k = 0; k <= kCells; ++k) {
      const double x = static_cast<double>(k), y = static_cast<double>(i);
      v.push_back(mesh.add_vertex({static_cast<Scalar>(x), static_cast<Scalar>(y),
                                   static_cast<Scalar>(std::sin(x / 2) * std::cos(y / 3))}));
    }
  }
  for (std::size_t i = 0; i < kCells; ++i) {
    for (std::size_t k = 0; k < kCells; ++k) {
      const std::size_t a = i * (kCells + 1) + k, b = a + kCells + 1;
      mesh.add_face(v[a], v[a + 1], v[b]);
      mesh.add_face(v[a + 1], v[b + 1], v[b]);
    }
  }
  return mesh;
}

/// A vertex of the sheet by column and row.
inline talweg::VertexId at(std::size_t column, std::size_t row) {
  return talweg::VertexId{row * (kCells + 1) + column};
}

/// A path from corner to corner in steps along the edges.
inline std::vector<talweg::VertexId> stairs() {
  std::vector<talweg::VertexId> path;
  for (std::size_t i = 1; i < kCells; ++i) {
    path.push_back(at(i, i));
    path.push_back(at(i + 1, i));
  }
  return path;
}

/// A square loop in the middle of the sheet; ends with its first vertex.
inline std::vector<talweg::VertexId> loop() {
  std::vector<talweg::VertexId> path;
  for (std::size_t i = 2; i < 6; ++i) path.push_back(at(i, 7));
  for (std::size_t i = 7; i < 11; ++i) path.push_back(at(6, i));
  for (std::size_t i = 6; i > 2; --i) path.push_back(at(i, 11));
  for (std::size_t i = 11; i >= 7; --i) path.push_back(at(2, i));
  return path;
}

}  // namespace docs
