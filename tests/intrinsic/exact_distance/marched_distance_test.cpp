// The marched distance in the plane, against the exact distance, within the error of its
// definition.
#include "talweg/intrinsic/exact_distance/marched_distance.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// A plane of n x n vertices with edges of length 1; vertex n * y + x.
Surface plane(std::size_t n) { return test::surface_of(test::grid(n - 1, n - 1)); }

std::vector<double> marched(const Surface& surface, std::vector<double> distance) {
  ProgressPoller poller({}, "distance");
  march_distance(surface, distance, poller);
  return distance;
}

TEST(MarchDistance, IsAccurateAroundAPoint) {
  constexpr std::size_t kSide = 41, kMiddle = 20;
  std::vector<double> start(kSide * kSide, kFar);
  const auto exact = [](std::size_t v) {
    return std::hypot(static_cast<double>(v % kSide) - kMiddle,
                      static_cast<double>(v / kSide) - kMiddle);
  };
  for (std::size_t v = 0; v < start.size(); ++v) {
    if (exact(v) < 3) start[v] = exact(v);
  }
  const std::vector<double> distance = marched(plane(kSide), start);
  for (std::size_t v = 0; v < distance.size(); ++v) EXPECT_NEAR(distance[v], exact(v), 1e-9) << v;
}

TEST(MarchDistance, IsAccurateAroundALine) {
  constexpr std::size_t kSide = 31;
  std::vector<double> start(kSide * kSide, kFar);
  for (std::size_t v = 0; v < 2 * kSide; ++v) start[v] = static_cast<double>(v / kSide);
  const std::vector<double> distance = marched(plane(kSide), start);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    // A circle of radius r through two corners at distance 1 bulges by 1 / (8 r); the bulges of the
    // rows add up.
    double bulge = 0;
    for (std::size_t row = 1; row < v / kSide; ++row)
      bulge += 1.0 / (8.0 * static_cast<double>(row));
    EXPECT_NEAR(distance[v], static_cast<double>(v / kSide), bulge + 1e-9) << v;
  }
}

TEST(MarchDistance, KeepsKnownDistancesAndLeavesUnreachableVertices) {
  std::vector<double> start(9, kFar);
  EXPECT_EQ(marched(plane(3), start), start);
  start[0] = 5;
  start[1] = 100;  // a given distance stays, although a way of length 6 exists
  const std::vector<double> distance = marched(plane(3), start);
  EXPECT_EQ(distance[0], 5);
  EXPECT_EQ(distance[1], 100);
  EXPECT_EQ(distance[3], 6);
}

TEST(MarchDistance, StopsWhenAsked) {
  std::vector<double> distance(101 * 101, kFar);
  distance[0] = 0;
  int asked = 0;
  ProgressPoller poller([&](const char*, double) { return ++asked < 2; }, "distance");
  EXPECT_THROW(march_distance(plane(101), distance, poller), Cancelled);
  std::vector<double> few(3, 0);
  ProgressPoller quiet({}, "distance");
  EXPECT_THROW(march_distance(plane(3), few, quiet), std::invalid_argument);
}

}  // namespace
}  // namespace talweg
