// The roughness of a mesh, and its smooth ground.
#include "talweg/core/mesh/smooth_ground.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/rough_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"

namespace talweg {
namespace {

using test::roughened;

SurfaceCurve across(const SurfaceMesh& mesh) {
  return test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), test::ids({0, 1, 4})),
                            false);
}

double roughness_of(const SurfaceMesh& mesh) {
  const SurfaceCurve curve = across(mesh);
  return roughness_along(mesh, std::span(&curve, 1));
}

/// A cube of side 1 whose faces are squares of 1 / n, cut in two.
MeshLists cube(std::uint32_t n) {
  MeshLists lists;
  std::vector<std::uint32_t> ids((n + 1) * (n + 1) * (n + 1), 0xFFFFFFFFU);
  const auto vertex = [&](std::array<std::uint32_t, 3> at) {
    std::uint32_t& id = ids[(at[0] * (n + 1) + at[1]) * (n + 1) + at[2]];
    if (id == 0xFFFFFFFFU) {
      id = static_cast<std::uint32_t>(lists.points.size());
      lists.points.emplace_back(at[0], at[1], at[2]);
      lists.points.back() /= n;
    }
    return id;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::uint32_t side : {0U, n}) {
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
          const auto corner = [&](std::uint32_t a, std::uint32_t b) {
            std::array<std::uint32_t, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = a;
            at[(axis + 2) % 3] = b;
            return vertex(at);
          };
          std::uint32_t a = corner(i, j), b = corner(i + 1, j);
          const std::uint32_t c = corner(i + 1, j + 1), d = corner(i, j + 1);
          std::array<Triangle, 2> halves{Triangle{a, b, c}, Triangle{a, c, d}};
          for (Triangle& t : halves) {
            if (side == 0) std::swap(t[1], t[2]);
            lists.triangles.push_back(t);
          }
        }
      }
    }
  }
  return lists;
}

TEST(SmoothGround, SmoothAndSharpEdgedMeshesAreNotRoughAndStayUnchanged) {
  const std::vector<MeshLists> smooth{test::sphere(6), test::tube(60, 60, 6), cube(20),
                                      test::torus(60, 24)};
  for (const MeshLists& lists : smooth) {
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    EXPECT_LT(roughness_of(mesh), kLeastRoughness) << lists.points.size();
    const SurfaceMesh ground = smooth_ground(mesh);
    for (std::size_t v = 0; v < mesh.points().size(); ++v) {
      ASSERT_EQ(ground.points()[v], mesh.points()[v]) << lists.points.size() << " " << v;
    }
  }
}

TEST(SmoothGround, NoiseIsEstimatedAndTakenAway) {
  const SurfaceMesh smooth = SurfaceMesh::open(test::sphere(6));
  const double h = smooth.mean_edge_length();
  for (const double rough : {0.1, 0.2, 0.3}) {
    const SurfaceMesh mesh = SurfaceMesh::open(roughened(test::sphere(6), rough * h));
    EXPECT_NEAR(roughness_of(mesh), rough, 0.2 * rough);
    const SurfaceMesh ground = smooth_ground(mesh);
    double left = 0, moved_aside = 0;
    for (std::size_t v = 0; v < ground.points().size(); ++v) {
      const Point& p = ground.points()[v];
      const Point normal = smooth.points()[v];  // of a unit sphere
      const double off = p.norm() - 1;
      left += off * off;
      const Point move = p - mesh.points()[v];
      moved_aside = std::max(moved_aside, (move - move.dot(normal) * normal).norm());
    }
    left = std::sqrt(left / static_cast<double>(ground.points().size()));
    EXPECT_LT(left, 0.35 * rough * h) << rough;
    EXPECT_LT(moved_aside, 0.5 * rough * h) << rough;
  }
}

TEST(SmoothGround, TheSameFarFromTheOriginAndAtAnyScale) {
  MeshLists lists = roughened(test::sphere(5), 0.01);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  MeshLists far = lists, small = lists;
  for (Point& p : far.points) p += Point(1048576, -524288, 4096);
  for (Point& p : small.points) p *= std::exp2(-60);
  EXPECT_NEAR(roughness_of(SurfaceMesh::open(far)), roughness_of(mesh), 1e-6);
  EXPECT_EQ(roughness_of(SurfaceMesh::open(small)), roughness_of(mesh));
}

TEST(SmoothGround, SmallMeshesAndBoundariesGiveNoNan) {
  for (const MeshLists& lists : {test::grid(1, 1), test::grid(2, 3), test::box(),
                                 test::with_isolated_vertices(test::grid(3, 3), 2)}) {
    const SurfaceMesh ground = smooth_ground(SurfaceMesh::open(lists));
    for (const Point& p : ground.points()) EXPECT_TRUE(p.allFinite());
  }
}

TEST(SmoothGround, IsMadeOnceAndCanBeCancelled) {
  const auto opened = OpenedMesh::open(roughened(test::sphere(5), 0.01));
  EXPECT_THROW(static_cast<void>(opened->ground([](const char*, double) { return false; })),
               Cancelled);
  const auto ground = opened->ground();
  EXPECT_EQ(opened->ground(), ground);
}

}  // namespace
}  // namespace talweg
