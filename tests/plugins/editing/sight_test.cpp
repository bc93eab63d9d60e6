// Sight: what lies under the mouse, and what the mesh hides.
#include "talweg/editing/sight.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "plugins/editing_drawings.hpp"

namespace talweg {
namespace {

using editing::MeshArrays;
using editing::Sight;
using editing::Vector;
using test::at;

/// A box from 0 to 1 of two triangles a side: z = 0 has the triangles 0 and 1, z = 1 has 2 and 3.
MeshArrays box_arrays() {
  MeshArrays mesh;
  for (const double z : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double x : {0.0, 1.0}) mesh.positions.push_back({x, y, z});
    }
  }
  mesh.triangles = {{0, 3, 1}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 7, 3}, {2, 6, 7}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Sight sight_of(MeshArrays mesh) {
  return Sight(std::make_shared<const MeshArrays>(std::move(mesh)));
}
Sight box() { return sight_of(box_arrays()); }

TEST(Sight, PointsBehindTheBodyAreHidden) {
  const Sight sight = box();
  const Vector above = {0.4, 0.6, 5};
  EXPECT_FALSE(sight.is_hidden(at(2), above));
  EXPECT_TRUE(sight.is_hidden(at(0), above));
  EXPECT_FALSE(sight.is_hidden(at(0), {0.4, 0.6, -5}));
  EXPECT_FALSE(sight.is_hidden(at(0), {0.5, 0.45, 0.5})) << "from inside";
}

TEST(Sight, PointsOnEdgesAndAtVerticesAreNotHiddenByTheirOwnFaces) {
  const Sight sight = box();
  const editing::Point vertex{2, {1, 0, 0}}, edge{2, {0.5, 0, 0.5}};
  for (const Vector& from : {Vector{0.3, 0.4, 3}, {-2, 0.5, 2}, {0.5, -2, 2}}) {
    EXPECT_FALSE(sight.is_hidden(edge, from));
    EXPECT_FALSE(sight.is_hidden(vertex, from));
  }
  EXPECT_TRUE(sight.is_hidden(edge, {0.4, 0.45, -2}));
  EXPECT_TRUE(sight.is_hidden(vertex, {0.3, 0.4, -2}));
}

TEST(Sight, AMissingFaceIsReported) {
  EXPECT_THROW((void)box().is_hidden(at(12), {0, 0, 5}), editing::Error);
}

TEST(Sight, TheNearestSideOfABoxIsMet) {
  const MeshArrays mesh = box_arrays();
  const Sight sight = box();
  const auto top = sight.first({0.2, 0.7, 9}, {0, 0, -2});
  ASSERT_TRUE(top);
  EXPECT_EQ(top->face, 3U);  // y > x
  const Vector there = position_of(mesh, *top);
  EXPECT_NEAR(there[0], 0.2, 1e-12);
  EXPECT_NEAR(there[1], 0.7, 1e-12);
  EXPECT_EQ(there[2], 1);
  const auto from_inside = sight.first({0.2, 0.7, 0.5}, {0, 0, -2});
  ASSERT_TRUE(from_inside);
  EXPECT_EQ(from_inside->face, 1U);
  EXPECT_FALSE(sight.first({0.2, 0.7, 9}, {0, 0, 2})) << "behind the eye";
  EXPECT_FALSE(sight.first({1.2, 0.7, 9}, {0, 0, -2})) << "beside the box";
  EXPECT_FALSE(sight_of({}).first({0, 0, 9}, {0, 0, -1})) << "no triangles";
}

/// Where a ray first meets a triangle, found by testing all of them.
std::optional<double> nearest(const MeshArrays& mesh, const Vector& from, const Vector& way) {
  std::optional<double> least;
  for (const auto& t : mesh.triangles) {
    MeshArrays alone;
    for (const std::uint32_t v : t) alone.positions.push_back(mesh.positions[v]);
    alone.triangles = {{0, 1, 2}};
    if (const auto point = sight_of(alone).first(from, way)) {
      const double d = editing::length(editing::minus(position_of(alone, *point), from));
      if (!least || d < *least) least = d;
    }
  }
  return least;
}

TEST(Sight, TheTreeAgreesWithTestsOfAllTriangles) {
  const MeshArrays mesh = test::arrays_of(test::tube(24, 20, 3.0));
  const Sight sight = sight_of(mesh);
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<double>(random() % 10001) / 2500 - 2; };
  int met = 0;
  for (int k = 0; k < 300; ++k) {
    const Vector from = {4 * number(), 4 * number(), 4 * number()};
    const Vector way = editing::minus({number(), number(), number()}, from);
    const auto expected = nearest(mesh, from, way);
    const auto found = sight.first(from, way);
    ASSERT_EQ(found.has_value(), expected.has_value()) << k;
    if (!found) continue;
    ++met;
    EXPECT_EQ(editing::length(editing::minus(position_of(mesh, *found), from)), *expected) << k;
  }
  EXPECT_GT(met, 50);
}

TEST(Sight, TrianglesWithoutAPlaceAreMetByNothing) {
  MeshArrays mesh = test::arrays_of(test::grid(6, 6));
  mesh.positions[24][2] = std::numeric_limits<double>::quiet_NaN();
  const Sight sight = sight_of(mesh);
  int met = 0;
  for (const auto& p : mesh.positions) {
    if (sight.first({p[0] + 0.3, p[1] + 0.2, 9}, {0, 0, -1})) ++met;
  }
  EXPECT_GT(met, 20);
}

}  // namespace
}  // namespace talweg
