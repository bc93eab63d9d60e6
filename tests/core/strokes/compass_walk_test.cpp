#include "talweg/core/strokes/compass_walk.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg::compass_walk_test {
namespace {

std::vector<Point> line(double length, double step) {
  std::vector<Point> points;
  for (double x = 0; x < length + step / 2; x += step) points.emplace_back(x, 0, 0);
  return points;
}

TEST(CompassWalk, GoesInEqualStepsHoweverALineIsSampled) {
  for (const double step : {0.013, 0.2, 1.0, 10.0}) {
    const auto places = compass_walk(line(10, step), false, 0.7);
    ASSERT_EQ(places.size(), 15U) << step;  // 14 steps; the end replaces the last step
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      EXPECT_NEAR(places[k].at.x(), 0.7 * static_cast<double>(k), 1e-9) << step;
    }
    EXPECT_NEAR(places.back().at.x(), 10, step);
  }
}

TEST(CompassWalk, AStepFarBelowTheSamplesIsNotWorthIt) {
  const std::vector<Point> points = line(10, 0.1);
  EXPECT_EQ(walkable_step(points, false, 0.3), 0.3);
  for (const double tiny : {1e-300, 1e-9, 1e-5}) {
    const double step = walkable_step(points, false, tiny);
    const std::size_t places = compass_walk(points, false, step).size();
    EXPECT_GT(places, 4000U);
    EXPECT_LT(places, 4100U + 16 * points.size());
  }
  const std::vector<Point> far{{1e9, 0, 0}, {1e9 + 1e-6, 0, 0}, {1e9 + 2e-6, 0, 0}};
  EXPECT_LE(compass_walk(far, false, walkable_step(far, false, 1e-300)).size(), 4U);
}

/// Segments of 1e-9 of the length, like a resting hand: the trembling is as small.
TEST(CompassWalk, AStrokeOfTinySegmentsHasASlackAtOnce) {
  const auto opened = OpenedMesh::open(test::grid(24, 24));
  std::vector<Point> points;
  for (int k = 0; k < 60; ++k) points.emplace_back(2 + 1e-9 * k, 2 + 1e-9 * (k % 2), 0);
  points.emplace_back(12, 2.5, 0);
  for (int k = 0; k < 60; ++k) points.emplace_back(22 + 1e-9 * k, 3 + 1e-9 * (k % 2), 0);
  const SnappedCurve snapped = snap(opened->mesh(), {false, points, {}});
  StraightLines lines(opened->surface());
  CurveSmoother smoother(opened);
  smoother.set_curve(lines.join(snapped.points, false));
  EXPECT_GT(smoother.smooth(1).report().after.length, 20);
}

TEST(CompassWalk, PassesOverRests) {
  std::vector<Point> points = line(10, 0.5);
  std::mt19937 random(1);
  std::normal_distribution<double> small(0, 0.004);
  std::vector<Point> rest;
  for (int k = 0; k < 60; ++k) {
    rest.push_back(points[8] + Point(small(random), small(random), small(random)));
  }
  const std::size_t before = compass_walk(points, false, 0.3).size();
  points.insert(points.begin() + 9, rest.begin(), rest.end());
  EXPECT_NEAR(static_cast<double>(compass_walk(points, false, 0.3).size()),
              static_cast<double>(before), 1);
}

TEST(CompassWalk, ASmallLoopIsPassedOverOnlyWhenRejoining) {
  std::vector<Point> points = line(5, 0.5);
  for (int k = 1; k <= 20; ++k) {  // a loop of radius 0.25 at (5, 0)
    const double t = 2 * 3.14159265358979 * k / 20;
    points.emplace_back(5 + 0.25 * std::sin(t), 0.25 - 0.25 * std::cos(t), 0);
  }
  for (double x = 5.5; x < 10.1; x += 0.5) points.emplace_back(x, 0, 0);
  const auto highest = [&](bool rejoining) {
    double y = 0;
    for (const PolylinePlace& place : compass_walk(points, false, 0.4, rejoining)) {
      y = std::max(y, std::abs(place.at.y()));
    }
    return y;
  };
  EXPECT_GT(highest(false), 0.2);
  EXPECT_LT(highest(true), 0.1);
}

TEST(CompassWalk, AClosedPolylineEndsBeforeItsFirstPoint) {
  const std::vector<Point> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const auto places = compass_walk(square, true, 1);
  EXPECT_EQ(places.size(), 16U);
  EXPECT_EQ(places.front().at, square.front());
  EXPECT_EQ(places.back().segment, 3U);
}

TEST(CompassWalk, AStepLongerThanThePolylineKeepsItsEnds) {
  const auto places = compass_walk(line(1, 0.1), false, 5);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places.front().at, Point(0, 0, 0));
  EXPECT_NEAR(places.back().at.x(), 1, 1e-12);
}

}  // namespace
}  // namespace talweg::compass_walk_test
