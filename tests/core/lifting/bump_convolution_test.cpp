#include "talweg/core/lifting/bump_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;
using test::surface_of_lists;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A sheet of 20 x 20 squares with inner vertices moved in the plane.
MeshLists crooked_sheet() {
  MeshLists lists = grid(20, 20);
  for (Point& p : lists.points) {
    if (p.x() < 0.5 || p.x() > 19.5 || p.y() < 0.5 || p.y() > 19.5) continue;
    p += Point(0.3 * std::sin(5 * p.x() + 3 * p.y()), 0.3 * std::cos(7 * p.x() - 2 * p.y()), 0);
  }
  return lists;
}

double distance_to_boundary(const Point& p) {
  return std::min({p.x(), p.y(), 20 - p.x(), 20 - p.y()});
}

/// ∫ h r³ dr / ∫ h r dr over [0, 1], by the midpoint rule with many steps.
double second_moment() {
  double above = 0;
  double below = 0;
  const int steps = 100000;
  for (int k = 0; k < steps; ++k) {
    const double r = (k + 0.5) / steps;
    const double h = std::exp(-1 / (1 - r * r));
    above += h * r * r * r;
    below += h * r;
  }
  return above / below;
}

TEST(BumpConvolution, ConstantsStayBitForBit) {
  for (const MeshLists& lists : {crooked_sheet(), test::sphere(3)}) {
    const Surface surface = surface_of_lists(lists);
    const std::vector<double> values(surface.vertex_count(), 0.1);
    for (const double radius : {0.01, 0.5, 3.0}) {
      EXPECT_EQ(convolve_with_bump(surface, values, {.radius = radius}), values);
    }
  }
}

TEST(BumpConvolution, LinearFunctionsOnAPlaneStay) {
  const MeshLists lists = crooked_sheet();
  const Surface surface = surface_of_lists(lists);
  std::vector<double> values;
  for (const Point& p : lists.points) values.push_back(100 + 2 * p.x() - 3 * p.y());
  for (const int rays : {4, 32, 50}) {
    const double radius = 3.2;
    const auto result = convolve_with_bump(surface, values, {.radius = radius, .rays = rays});
    std::size_t inside = 0;
    for (std::size_t v = 0; v < values.size(); ++v) {
      if (distance_to_boundary(lists.points[v]) <= radius) continue;
      ++inside;
      EXPECT_NEAR(result[v], values[v], 1e-12) << v;
    }
    EXPECT_GT(inside, 150U);
  }
}

TEST(BumpConvolution, QuadraticFunctionsRiseByTheSecondMoment) {
  // x² + y² averages to x² + y² + ∫ h r³ / ∫ h r; on the mesh it is interpolated linearly, which
  // adds between 0 and half of 2 · (edge length)² / 4, with 1/16 of the radius as edge length.
  MeshLists lists = grid(64, 64);
  for (Point& p : lists.points) p /= 16;
  const Surface surface = surface_of_lists(lists);
  std::vector<double> values;
  for (const Point& p : lists.points) values.push_back(p.squaredNorm());
  const auto result = convolve_with_bump(surface, values, {.radius = 1, .rays = 64, .samples = 24});
  const std::size_t centre = 32 * 65 + 32;
  const double rise = result[centre] - values[centre];
  EXPECT_GT(rise, second_moment() - 1e-4);
  EXPECT_LT(rise, second_moment() + 0.5 / (16 * 16) + 1e-4);
}

TEST(BumpConvolution, RoundsTheKinkOfADistance) {
  // |x| becomes positive at 0, stays unchanged beyond the radius from the kink, and changes by at
  // most the radius.
  const MeshLists lists = grid(20, 20);
  const Surface surface = surface_of_lists(lists);
  std::vector<double> values;
  for (const Point& p : lists.points) values.push_back(std::abs(p.x() - 10));
  const double radius = 4;
  const auto result = convolve_with_bump(surface, values, {.radius = radius});
  for (std::size_t v = 0; v < values.size(); ++v) {
    EXPECT_LE(std::abs(result[v] - values[v]), radius);
    if (distance_to_boundary(lists.points[v]) <= radius) continue;
    if (values[v] >= radius) {
      EXPECT_NEAR(result[v], values[v], 1e-12);
    } else {
      EXPECT_GT(result[v], values[v]);
    }
  }
  EXPECT_NEAR(result[10 * 21 + 6], 4, 1e-12);
}

TEST(BumpConvolution, SymmetricOnASphere) {
  // On a sphere z is an eigenfunction of every rotationally symmetric mean: z shrinks by one
  // factor.
  const MeshLists lists = test::sphere(5);
  const Surface surface = surface_of_lists(lists);
  std::vector<double> values;
  for (const Point& p : lists.points) values.push_back(p.z());
  const double radius = 0.5;
  const auto result = convolve_with_bump(surface, values, {.radius = radius});
  double above = 0;
  double below = 0;
  for (int k = 0; k < 10000; ++k) {
    const double r = (k + 0.5) / 10000;
    const double h = std::exp(-1 / (1 - r * r));
    above += h * r * std::cos(radius * r);  // area element of the plane, as along the rays
    below += h * r;
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    EXPECT_NEAR(result[v], values[v] * above / below, 2e-3) << v;
  }
}

TEST(BumpConvolution, BoundaryAveragesOnlyInnerValues) {
  const MeshLists lists = grid(10, 10);
  const Surface surface = surface_of_lists(lists);
  std::vector<double> values;
  for (const Point& p : lists.points) values.push_back(p.x());
  const auto result = convolve_with_bump(surface, values, {.radius = 2});
  EXPECT_GT(result[5 * 11], 0.1);  // at x = 0 the neighbours have only larger values
  EXPECT_LT(result[5 * 11], 2);
  EXPECT_LT(result[5 * 11 + 10], 9.9);
  EXPECT_NEAR(result[5 * 11 + 5], 5, 1e-12);
  EXPECT_NEAR(result[5], 5, 1e-12);  // symmetric about the middle of the side
}

TEST(BumpConvolution, UnreachedStaysUnreached) {
  MeshLists lists = grid(4, 4);
  const auto first = static_cast<std::uint32_t>(lists.points.size());
  for (int k = 0; k < 4; ++k) lists.points.push_back(Point(k, k % 2, 7));
  lists.triangles.push_back({first, first + 1, first + 2});  // the last vertex is isolated
  const Surface surface = surface_of_lists(lists);
  std::vector<double> values(surface.vertex_count(), 3.0);
  for (std::size_t k = 0; k < 3; ++k) values[first + k] = kInfinity;
  EXPECT_EQ(convolve_with_bump(surface, values, {.radius = 2}), values);
  // A component that is only partly infinite.
  values[0] = kInfinity;
  EXPECT_EQ(convolve_with_bump(surface, values, {.radius = 2}), values);
}

TEST(BumpConvolution, DegenerateTriangles) {
  // A duplicate vertex, a face of zero area with three positions, a spike of almost no angle.
  MeshLists lists;
  lists.points = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0),    Point(1, 0, 0),
                  Point(1, 2, 0), Point(1, 0, 9), Point(1, 1e-14, 9)};
  lists.triangles = {{0, 1, 4}, {1, 2, 4}, {1, 3, 2}, {0, 3, 1}, {0, 5, 3}, {5, 6, 3}, {6, 2, 3}};
  const Surface surface = surface_of_lists(lists);
  const std::vector<double> values{0, 1, 2, 3, 4, 5, 6};
  for (const double radius : {1e-3, 1.0, 100.0}) {
    const auto result = convolve_with_bump(surface, values, {.radius = radius});
    for (const double r : result) EXPECT_TRUE(r >= 0 && r <= 6) << r;
  }
}

TEST(BumpConvolution, ScalesWithTheMesh) {
  MeshLists lists = test::sphere(2);
  std::vector<double> values;
  for (const Point& p : lists.points) values.push_back(std::abs(p.x() + p.y() * p.z()));
  const auto result = convolve_with_bump(surface_of_lists(lists), values, {.radius = 0.7});
  for (Point& p : lists.points) p *= 1e-8;
  const auto small = convolve_with_bump(surface_of_lists(lists), values, {.radius = 0.7e-8});
  for (std::size_t v = 0; v < values.size(); ++v) EXPECT_NEAR(small[v], result[v], 1e-13);
}

TEST(BumpConvolution, RadiusZeroAndBadInput) {
  const Surface surface = surface_of_lists(grid(2, 2));
  std::vector<double> values{0, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(convolve_with_bump(surface, values, {}), values);
  for (const BumpOptions& bad :
       {BumpOptions{.radius = -1}, BumpOptions{.radius = kInfinity}, BumpOptions{.rays = 5},
        BumpOptions{.rays = 2}, BumpOptions{.samples = 1}, BumpOptions{.samples = 65}}) {
    EXPECT_THROW(convolve_with_bump(surface, values, bad), Error);
  }
  values[4] = std::numeric_limits<double>::quiet_NaN();
  try {
    convolve_with_bump(surface, values, {.radius = 1});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
    EXPECT_NE(std::string(error.what()).find("vertex 4"), std::string::npos);
  }
  values.pop_back();
  EXPECT_THROW(convolve_with_bump(surface, values, {.radius = 1}), Error);
}

}  // namespace
}  // namespace talweg
