#include "talweg/core/measure/edge_length_near.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::surface_of_lists;

// Two rings around one vertex of a grid whose squares are cut along one diagonal: a hexagon with
// 19 vertices and 42 edges, a third of them diagonals.
TEST(EdgeLengthNear, IsTheMeanOfTwoRings) {
  const Surface surface = surface_of_lists(grid(8, 8));
  const SurfaceCurve point = test::vertex_curve(surface, ids({40}), false);
  EXPECT_NEAR(edge_length_near(surface, point), (28 + 14 * std::sqrt(2.0)) / 42, 1e-12);
}

TEST(EdgeLengthNear, CountsEveryEdgeOfASmallMeshOnce) {
  const Surface surface = surface_of_lists(grid(2, 2));  // nine vertices: all within two rings
  double sum = 0;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) sum += surface.length(EdgeId{e});
  const double mean = sum / static_cast<double>(surface.edge_count());
  EXPECT_NEAR(edge_length_near(surface, test::vertex_curve(surface, ids({4}), false)), mean, 1e-12);
  // Points in faces and on edges stand for their corners.
  const SurfaceCurve inside{false,
                            {SurfacePoint::in_face(surface, FaceId{3}, {0.2, 0.3, 0.5}),
                             test::between(surface, 4, 8, 0.5)}};
  EXPECT_NEAR(edge_length_near(surface, inside), mean, 1e-12);
}

TEST(EdgeLengthNear, FollowsTheScale) {
  MeshLists lists = grid(8, 8);
  for (Point& p : lists.points) p *= 1e-3;
  const Surface surface = surface_of_lists(lists);
  const SurfaceCurve point = test::vertex_curve(surface, ids({40}), false);
  EXPECT_NEAR(edge_length_near(surface, point), 1e-3 * (28 + 14 * std::sqrt(2.0)) / 42, 1e-15);
}

}  // namespace
}  // namespace talweg
