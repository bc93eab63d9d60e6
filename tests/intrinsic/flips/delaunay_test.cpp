#include "talweg/intrinsic/flips/delaunay.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

using namespace test;

using Corners = std::array<std::size_t, 3>;

std::vector<Corners> sorted_corners(const std::vector<MetricTriangle>& triangles) {
  std::vector<Corners> list;
  for (const MetricTriangle& t : triangles) {
    Corners c = {t.corner[0].index(), t.corner[1].index(), t.corner[2].index()};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    list.push_back(c);
  }
  std::sort(list.begin(), list.end());
  return list;
}

/// The surface with another triangulation, by random flips of planar triangles.
Surface flipped(const TestMesh& mesh, std::uint64_t seed) {
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  Random random(seed);
  flip_at_random(t, random, 3000);
  TestMesh result = mesh;
  result.triangles.clear();
  for (std::size_t i = 0; i < s.halfedge_count(); ++i) {
    const HalfedgeId h{i};
    if (!t.has_face(h) || t.next(h) < h || t.prev(h) < h) continue;
    result.triangles.push_back({static_cast<std::uint32_t>(t.tail(h).index()),
                                static_cast<std::uint32_t>(t.head(h).index()),
                                static_cast<std::uint32_t>(t.tail(t.prev(h)).index())});
  }
  return surface_of(result);
}

TEST(Delaunay, TrianglesDoNotDependOnWhereFlipsStart) {
  const TestMesh mesh = grid(9, 9, 0.24);
  const auto expected = sorted_corners(delaunay_triangles(surface_of(mesh)));
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    std::size_t flips = 0;
    EXPECT_EQ(sorted_corners(delaunay_triangles(flipped(mesh, seed), &flips)), expected);
    EXPECT_GT(flips, 50U);
  }
}

TEST(Delaunay, PlanarTrianglesHaveEmptyCircles) {
  const TestMesh mesh = grid(7, 7, 0.24);
  for (const MetricTriangle& t : delaunay_triangles(flipped(mesh, 4))) {
    const Point &a = mesh.points[t.corner[0].index()], &b = mesh.points[t.corner[1].index()],
                &c = mesh.points[t.corner[2].index()];
    EXPECT_NEAR(t.length[0], distance(a, b), 1e-10);
    EXPECT_NEAR(t.length[1], distance(b, c), 1e-10);
    EXPECT_NEAR(t.length[2], distance(c, a), 1e-10);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Point& p = mesh.points[v];
      const auto row = [&](const Point& q) {
        const double x = q[0] - p[0], y = q[1] - p[1];
        return std::array{x, y, x * x + y * y};
      };
      const auto r = row(a), s = row(b), u = row(c);
      const double inside = r[0] * (s[1] * u[2] - s[2] * u[1]) -
                            r[1] * (s[0] * u[2] - s[2] * u[0]) + r[2] * (s[0] * u[1] - s[1] * u[0]);
      EXPECT_LE(inside, 1e-9);
    }
  }
}

/// Expects non-negative cotan weights of all inner edges.
void expect_weights_not_negative(const Surface& s) {
  SignpostTriangulation t(s);
  std::vector<MetricTriangle> triangles = delaunay_triangles(s);
  EXPECT_EQ(triangles.size(), s.face_count());
  // Sides with the same ends and length are one edge, on surfaces without multi-edges of equal
  // length.
  std::map<std::array<std::size_t, 2>, std::vector<std::array<double, 2>>> opposite;
  for (const MetricTriangle& m : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = m.corner[k].index(), b = m.corner[(k + 1) % 3].index();
      opposite[{std::min(a, b), std::max(a, b)}].push_back(
          {m.length[k], angle_between(m.length[(k + 1) % 3], m.length[(k + 2) % 3], m.length[k])});
    }
  }
  for (auto& [ends, sides] : opposite) {
    std::sort(sides.begin(), sides.end());
    if (sides.size() != 2 || sides[0][0] != sides[1][0]) continue;
    EXPECT_LE(sides[0][1] + sides[1][1], kPi + 1e-6);
  }
}

TEST(Delaunay, WeightsAreNotNegative) {
  expect_weights_not_negative(surface_of(sphere(3)));
  expect_weights_not_negative(surface_of(torus(12, 5, 3, 1)));
  expect_weights_not_negative(surface_of(cylinder(5, 2, 1, 9)));
  expect_weights_not_negative(flipped(grid(9, 9, 0.24), 6));
}

TEST(Delaunay, KeepsTheAreaOfRandomComplexes) {
  Random random(12);
  for (int k = 0; k < 300; ++k) {
    const Surface s = random_complex(random, 1 + random.below(12), random.uniform(0, 0.4));
    const auto area = [](const std::vector<MetricTriangle>& list) {
      double sum = 0;
      for (const auto& t : list) sum += triangle_area(t.length[0], t.length[1], t.length[2]);
      return sum;
    };
    const auto triangles = delaunay_triangles(s);
    ASSERT_EQ(triangles.size(), s.face_count());
    EXPECT_NEAR(area(triangles), area(metric_triangles(s)), 1e-9);
  }
}

TEST(Delaunay, EndsOnNeedlesAndZeroAreas) {
  Random random(13);
  for (int k = 0; k < 300; ++k) {
    const Surface s = random_complex(random, 1 + random.below(12), 0.1, 8);
    EXPECT_EQ(delaunay_triangles(s).size(), s.face_count());
  }
  for (int k = 0; k < 50; ++k) {
    TestMesh mesh = grid(8, 8, 0.2, static_cast<std::uint64_t>(k + 1));
    // Vertices moved onto other vertices and onto edges.
    for (int i = 0; i < 12; ++i) {
      const std::size_t v = random.below(mesh.points.size());
      const std::size_t w = v + 1 < mesh.points.size() ? v + 1 : v - 1;
      mesh.points[v] = mesh.points[w];
    }
    const Surface s = surface_of(mesh);
    std::size_t flips = 0;
    for (const MetricTriangle& t : delaunay_triangles(s, &flips)) {
      for (const double length : t.length) EXPECT_TRUE(std::isfinite(length) && length >= 0);
    }
    EXPECT_LT(flips, 10 * s.edge_count());
  }
  Surface nothing = surface_of(octahedron());
  nothing.set_lengths(std::vector<double>(nothing.edge_count(), 0.0));
  EXPECT_EQ(delaunay_triangles(nothing).size(), 8U);
}

TEST(Delaunay, FlatTriangleIsFlippedAway) {
  // Vertex 2 lies on the edge 0-1; below it a proper triangle.
  const TestMesh mesh = {{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  std::size_t flips = 0;
  const auto triangles = delaunay_triangles(surface_of(mesh), &flips);
  EXPECT_EQ(flips, 1U);
  for (const auto& t : triangles) {
    EXPECT_NEAR(triangle_area(t.length[0], t.length[1], t.length[2]), 0.5, 1e-15);
  }
}

TEST(Delaunay, ScalesWithoutLoss) {
  const TestMesh mesh = grid(9, 9, 0.24);
  const auto expected = sorted_corners(delaunay_triangles(flipped(mesh, 1)));
  for (const double scale : {1e-8, 1e8}) {
    Surface s = flipped(mesh, 1);
    std::vector<double> lengths(s.lengths().begin(), s.lengths().end());
    for (double& l : lengths) l *= scale;
    s.set_lengths(lengths);
    EXPECT_EQ(sorted_corners(delaunay_triangles(s)), expected);
  }
}

}  // namespace
}  // namespace talweg
