#include "talweg/heat/mollification.hpp"

#include <gtest/gtest.h>

#include "heat/test_surfaces.hpp"

namespace talweg {
namespace {

/// The smallest slack of the triangle inequality over all triangles.
double least_slack(const Surface& surface, const std::vector<double>& lengths) {
  double least = 1e300;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const HalfedgeId h = surface.halfedge(FaceId{f});
    const double a = lengths[edge_of(h).index()];
    const double b = lengths[edge_of(surface.next(h)).index()];
    const double c = lengths[edge_of(surface.prev(h)).index()];
    least = std::min({least, a + b - c, b + c - a, c + a - b});
  }
  return least;
}

test::TestMesh flat_triangle() {
  test::TestMesh mesh = test::grid(3, 3);
  mesh.positions[5] = mesh.positions[4];  // two vertices at one place: triangles without area
  return mesh;
}

TEST(Mollification, GoodMeshesAreNotTouched) {
  const Surface surface = test::sphere(2).surface();
  const Mollification result = mollify(surface, components_of(surface));
  EXPECT_FALSE(result.changed());
  EXPECT_EQ(result.amount, std::vector<double>{0.0});
  EXPECT_TRUE(std::equal(result.lengths.begin(), result.lengths.end(), surface.lengths().begin()));
}

TEST(Mollification, AddsTheSmallestAmountThatGivesTheSlack) {
  const Surface surface = flat_triangle().surface();
  const Components components = components_of(surface);
  const double h = mean_edge_lengths(surface, components)[0];
  const Mollification result = mollify(surface, components, 1e-3);
  EXPECT_NEAR(result.amount[0], 1e-3 * h, 1e-15);
  EXPECT_NEAR(least_slack(surface, result.lengths), 1e-3 * h, 1e-15);
}

TEST(Mollification, SeesCapsWhateverSideIsTheLongest) {
  // A vertex in the middle of the opposite side: no side is short, but the slack is 0.
  const std::vector<Triangle> one = {{0, 1, 2}};
  for (std::size_t longest = 0; longest < 3; ++longest) {
    Surface surface = Surface::from_triangles(3, one);
    std::vector<double> lengths(3, 1.0);
    lengths[longest] = 2;
    surface.set_lengths(lengths);
    const Mollification result = mollify(surface, components_of(surface), 1e-3);
    EXPECT_NEAR(result.amount[0], 1e-3 * 4 / 3, 1e-15) << longest;
  }
}

TEST(Mollification, ComponentsAreIndependentAndScaleCovariant) {
  const Surface surface =
      test::together(test::grid(2, 2), test::scaled(flat_triangle(), 0x1p-40)).surface();
  const Mollification result = mollify(surface, components_of(surface));
  const Surface alone = flat_triangle().surface();
  ASSERT_EQ(result.amount.size(), 2u);
  EXPECT_EQ(result.amount[0], 0);
  EXPECT_EQ(result.amount[1], 0x1p-40 * mollify(alone, components_of(alone)).amount[0]);
}

TEST(Mollification, MeanEdgeLengthsByComponent) {
  test::TestMesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}};
  const Surface surface = mesh.surface();
  const auto h = mean_edge_lengths(surface, components_of(surface));
  EXPECT_EQ(h, (std::vector<double>{4, 0}));  // (3 + 4 + 5) / 3, and an isolated vertex
}

}  // namespace
}  // namespace talweg
