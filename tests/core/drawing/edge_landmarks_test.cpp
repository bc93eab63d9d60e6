// Landmarks change nothing but the time: paths are the same as those of a search without them.
#include "talweg/core/drawing/edge_landmarks.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

/// Random legs, so many that the searches have looked at 16 whole meshes long before the last.
void expect_same_paths(const MeshLists& lists, std::size_t clicks) {
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const Surface& surface = mesh.surface();
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> vertex(0, surface.vertex_count() - 1);
  EdgeDijkstra many(surface);
  for (std::size_t leg = 0; leg < 200; ++leg) {
    std::vector<VertexId> through;
    while (through.size() < clicks) {
      const VertexId v{vertex(random)};
      if (std::find(through.begin(), through.end(), v) == through.end()) through.push_back(v);
    }
    const auto drawn = [&](EdgeDijkstra& dijkstra) {
      try {
        return dijkstra.draw(through, clicks > 2);
      } catch (const Error&) {  // earlier legs are in the way
        return std::vector<VertexId>();
      }
    };
    EdgeDijkstra alone(surface);
    ASSERT_EQ(drawn(many), drawn(alone)) << leg;
  }
}

TEST(EdgeLandmarks, GiveTheSamePathsOnHills) { expect_same_paths(test::hills(30), 2); }

/// On a grid nearly every leg has many shortest paths.
TEST(EdgeLandmarks, GiveTheSameOfManyShortestPaths) { expect_same_paths(test::grid(30, 30), 2); }

TEST(EdgeLandmarks, GiveTheSameClosedPathsAmongBlockedVertices) {
  expect_same_paths(test::sphere(4), 4);
}

TEST(EdgeLandmarks, BoundDistancesFromBelow) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  ProgressPoller poller({}, "draw");
  EdgeLandmarks landmarks(mesh.surface(), VertexId{220U}, poller);
  const PathEnd goal{VertexId{0U}};
  landmarks.aim({&goal, 1});
  EXPECT_EQ(landmarks.bound(VertexId{0U}), 0);
  // Along the lower side from its corner: the landmark there is exact, but for single precision.
  for (std::size_t x = 1; x <= 20; ++x) {
    EXPECT_LE(landmarks.bound(VertexId{x}), static_cast<double>(x));
    EXPECT_NEAR(landmarks.bound(VertexId{x}), static_cast<double>(x), 1e-4) << x;
  }
}

}  // namespace
}  // namespace talweg
