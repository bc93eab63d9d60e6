// Vertices around which shortest paths bend, on grids and boxes of unit squares.
#include "talweg/intrinsic/exact_distance/bending_vertices.hpp"

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

TEST(BendingVertices, AreTheInnerCornersOfAHole) {
  // The middle cell of 3 x 3 is missing.
  const Surface surface = test::surface_of(
      test::grid_without(3, 3, [](std::size_t i, std::size_t j) { return i == 1 && j == 1; }));
  BendingVertices bending(surface);
  for (std::size_t j = 0; j <= 3; ++j) {
    for (std::size_t i = 0; i <= 3; ++i) {
      const bool at_hole = (i == 1 || i == 2) && (j == 1 || j == 2);  // an angle of 3/4 of a turn
      for (int again = 0; again < 2; ++again) {
        EXPECT_EQ(bending.contain(VertexId{i + 4 * j}), at_hole) << i << " " << j;
      }
    }
  }
}

TEST(BendingVertices, AreSaddlesAndNotCones) {
  // An L of boxes: two saddles of 5/4 turns at the ends of the inner edge, x = 1 and z = 1.
  const test::TestMesh mesh =
      test::voxels(2, 2, 2, [](int i, int, int k) { return i < 1 || k < 1; });
  const Surface surface = test::surface_of(mesh);
  BendingVertices bending(surface);
  std::size_t saddles = 0;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    const test::Point& p = mesh.points[v];
    const bool saddle = p[0] == 1 && p[2] == 1 && (p[1] == 0 || p[1] == 2);
    EXPECT_EQ(bending.contain(VertexId{v}), saddle) << p[0] << " " << p[1] << " " << p[2];
    saddles += saddle;
  }
  EXPECT_EQ(saddles, 2U);
}

TEST(BendingVertices, AreTheEndsOfEdgesOfNoLength) {
  test::TestMesh mesh = test::grid(4, 4);
  mesh.points[12] = mesh.points[11];
  const Surface surface = test::surface_of(mesh);
  BendingVertices bending(surface);
  EXPECT_TRUE(bending.contain(VertexId{11}));
  EXPECT_TRUE(bending.contain(VertexId{12}));
}

TEST(BendingVertices, DoNotIncludeIsolatedVertices) {
  test::TestMesh mesh = test::grid(1, 1);
  mesh.points.push_back({5, 5, 5});
  const Surface surface = test::surface_of(mesh);
  EXPECT_FALSE(BendingVertices(surface).contain(VertexId{4}));
}

}  // namespace
}  // namespace talweg
