// An OpenMesh tool that smooths a curve on its own meshes, of any traits.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/openmesh.hpp"

constexpr int kCells = 8;

struct DoublePoints : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;  // normals stay in single precision
};

/// A flat square of kCells x kCells cells; its diagonal is not a mesh edge.
template <class Mesh>
Mesh square() {
  Mesh mesh;
  std::vector<typename Mesh::VertexHandle> v;
  for (int i = 0; i <= kCells; ++i) {
    for (int k = 0; k <= kCells; ++k) v.push_back(mesh.add_vertex(typename Mesh::Point(k, i, 0)));
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

template <class Mesh>
double smoothed_length(const Mesh& mesh, double tau) {
  talweg::CurveSmoother smoother(talweg::OpenedMesh::open(talweg::surface_of(mesh)));
  std::vector<talweg::VertexId> stairs;  // along edges, from corner to corner
  for (std::size_t i = 0; i <= kCells; ++i) {
    stairs.emplace_back(i * (kCells + 1) + i);
    if (i < kCells) stairs.emplace_back(i * (kCells + 1) + i + 1);
  }
  smoother.set_curve(talweg::curve_through(smoother.opened().surface(), stairs));
  return smoother.smooth(tau).report().after.length;
}

template <class Mesh>
void check(const char* name) {
  const Mesh mesh = square<Mesh>();
  const double straight = std::sqrt(2.0) * kCells, drawn = 2.0 * kCells;
  const double geodesic = smoothed_length(mesh, 0), smooth = smoothed_length(mesh, 1);
  std::printf("%s: drawn %.6f, smoothed %.6f, straight %.6f\n", name, drawn, smooth, geodesic);
  if (std::abs(geodesic - straight) > 1e-12 * straight || smooth >= drawn ||
      smooth < straight * (1 - 1e-12)) {
    std::exit(1);
  }
}

int main() {
  check<OpenMesh::TriMesh_ArrayKernelT<>>("single precision");
  check<OpenMesh::TriMesh_ArrayKernelT<DoublePoints>>("double points");
}
