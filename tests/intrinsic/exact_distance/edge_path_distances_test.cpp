// Paths along the edges of grids to vertices with given distances.
#include "talweg/intrinsic/exact_distance/edge_path_distances.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

TEST(EdgePathDistances, LeadToTheBestVertexWithinTheLimit) {
  const Surface surface = test::surface_of(test::grid(3, 3));
  const auto id = [](std::size_t i, std::size_t j) { return VertexId{i + 4 * j}; };
  VertexDistances known(surface.vertex_count());
  known.lower(id(0, 0), {0, 4, 1});
  known.lower(id(3, 0), {0.5, 5, 2});
  known.lower(id(3, 2), {1.5, 6, 3});
  EdgePathDistances ways(surface);
  WorkTally work;
  // The first known vertex is three diagonals away, the second three sides.
  const NearestOnCurve near = ways.shortest(id(3, 3), 1, known, work);
  EXPECT_DOUBLE_EQ(near.distance, 3.5);
  EXPECT_EQ(near.curve, 5U);
  EXPECT_EQ(near.arc_length, 2);
  EXPECT_DOUBLE_EQ(ways.shortest(id(3, 3), 0.25, known, work).distance, 3 * std::sqrt(2.0));
  // A limit of 2 admits the third known vertex, one side away.
  EXPECT_DOUBLE_EQ(ways.shortest(id(3, 3), 2, known, work).distance, 2.5);
}

TEST(EdgePathDistances, LeadAcrossManyVertices) {
  constexpr std::size_t n = 40;
  const Surface surface = test::surface_of(test::grid(n, n));
  VertexDistances known(surface.vertex_count());
  known.lower(VertexId{0}, {0, 0, 0});
  EdgePathDistances ways(surface);
  WorkTally work;
  // Shortest edge paths use the diagonals of the grid as far as possible.
  for (const auto& [i, j] : {std::array<std::size_t, 2>{n, n}, {n, 10}, {0, n}, {30, 35}}) {
    const double least = static_cast<double>(std::min(i, j));
    const double most = static_cast<double>(std::max(i, j));
    EXPECT_NEAR(ways.shortest(VertexId{i + (n + 1) * j}, 0, known, work).distance,
                least * std::sqrt(2.0) + most - least, 1e-12);
  }
  // Changed distances require clear().
  known.clear();
  known.lower(VertexId{n}, {0, 0, 0});
  ways.clear();
  EXPECT_NEAR(ways.shortest(VertexId{(n + 1) * n + n}, 0, known, work).distance, n, 1e-12);
}

TEST(EdgePathDistances, AreInfiniteWithoutKnownVertices) {
  test::TestMesh mesh = test::grid(3, 3);
  mesh.points.push_back({9, 9, 9});
  const Surface surface = test::surface_of(mesh);
  VertexDistances known(surface.vertex_count());
  known.lower(VertexId{0}, {0, 0, 0});
  EdgePathDistances ways(surface);
  WorkTally work;
  EXPECT_TRUE(std::isinf(ways.shortest(VertexId{16}, 1, known, work).distance));
}

TEST(EdgePathDistances, CountTheirWorkAndContinue) {
  constexpr std::size_t n = 60;
  const Surface surface = test::surface_of(test::grid(n, n));
  VertexDistances known(surface.vertex_count());
  known.lower(VertexId{0}, {0, 0, 0});
  EdgePathDistances ways(surface);
  WorkTally work;
  bool may = true;
  ProgressPoller poller([&](const char*, double) { return may; }, "ways");
  work.set_poller(&poller);
  may = false;
  const VertexId last{(n + 1) * (n + 1) - 1};
  EXPECT_THROW(ways.shortest(last, 0, known, work), Cancelled);
  may = true;
  EXPECT_NEAR(ways.shortest(last, 0, known, work).distance, n * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace talweg
