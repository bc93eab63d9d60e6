// As a tool uses it: OpenMesh meshes of either precision, several threads.
#include <cmath>
#include <cstring>
#include <thread>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {
namespace {

struct DoubleToolPoints : OpenMesh::DefaultTraits {
  typedef OpenMesh::Vec3d Point;  // normals stay float
};
using FloatMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleToolPoints>;

MeshLists bumpy_ball() {
  MeshLists lists = test::sphere(4);
  for (Point& p : lists.points) {
    p *= 1 + 0.15 * std::sin(5 * p.x() + 0.3) * std::cos(4 * p.y()) + 0.1 * std::sin(7 * p.z());
  }
  return lists;
}

template <class Mesh>
Mesh as_openmesh(const MeshLists& lists) {
  Mesh mesh;
  using Scalar = typename Mesh::Scalar;
  std::vector<OpenMesh::VertexHandle> handles;
  for (const Point& p : lists.points) {
    handles.push_back(mesh.add_vertex(typename Mesh::Point(
        static_cast<Scalar>(p.x()), static_cast<Scalar>(p.y()), static_cast<Scalar>(p.z()))));
  }
  for (const Triangle& t : lists.triangles) {
    mesh.add_face(handles[t[0]], handles[t[1]], handles[t[2]]);
  }
  return mesh;
}

template <class Mesh>
std::vector<Point> smoothed(const Mesh& mesh, double tau) {
  const auto opened = open_mesh(mesh);
  const auto path = draw_edge_path(opened->surface(), test::ids({0, 600, 3, 200}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), path, false);
  return positions_of(opened->mesh(), smooth_curve(opened, drawn, {.tau = tau}).curve());
}

TEST(EmbeddingInTools, SinglePrecisionMeshesGiveTheSameWithinTheirPrecision) {
  const MeshLists lists = bumpy_ball();
  for (const double tau : {0.0, 0.5, 2.0}) {
    const auto fine = smoothed(as_openmesh<DoubleMesh>(lists), tau);
    const auto coarse = smoothed(as_openmesh<FloatMesh>(lists), tau);
    ASSERT_EQ(fine.size(), coarse.size()) << tau;
    // Points of size 1 are rounded by 6e-8; where two edges cross at a flat angle it shows a
    // thousandfold.
    for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_LT((fine[i] - coarse[i]).norm(), 1e-4);
  }
}

TEST(EmbeddingInTools, ThreadsShareAnOpenedMesh) {
  const auto opened = OpenedMesh::open(bumpy_ball());
  const auto path = draw_edge_path(opened->surface(), test::ids({0, 600, 3, 200}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), path, false);
  constexpr std::size_t kThreads = 4;
  std::vector<std::vector<Point>> results(kThreads);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < kThreads; ++k) {
    threads.emplace_back([&, k] {
      CurveSmoother smoother(opened);  // the first thread makes the factors
      smoother.set_curve(drawn);
      for (const double tau : {0.1, 3.0, 1.0}) {
        results[k] = positions_of(opened->mesh(), smoother.smooth(tau).curve());
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 1; k < kThreads; ++k) {
    ASSERT_EQ(results[k].size(), results[0].size());
    EXPECT_EQ(std::memcmp(results[k].data(), results[0].data(), results[0].size() * sizeof(Point)),
              0);
  }
}

}  // namespace
}  // namespace talweg
