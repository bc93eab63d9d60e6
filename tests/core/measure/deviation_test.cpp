#include "talweg/core/measure/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/reference_data.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

std::vector<Point> random_walk(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> step(-1, 1);
  std::vector<Point> points{Point::Zero()};
  while (points.size() < count) {
    points.push_back(points.back() + Point(step(engine), step(engine), step(engine)));
  }
  return points;
}

double brute_force(const std::vector<Segment>& segments, const Point& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments) best = std::min(best, distance_to(s, p));
  return best;
}

TEST(NearestSegment, AgreesWithASearchOfAllSegments) {
  const auto walk = random_walk(300, 1);
  const NearestSegment tree(segments_of(walk, true));
  const std::vector<Segment> all(tree.segments().begin(), tree.segments().end());
  ASSERT_EQ(all.size(), 300U);
  for (const Point& p : random_walk(500, 2)) {
    const auto nearest = tree.to(p);
    EXPECT_EQ(nearest.distance, brute_force(all, p));
    EXPECT_EQ(distance_to(all[nearest.segment], p), nearest.distance);
  }
  for (const Point& p : walk) EXPECT_EQ(tree.to(p).distance, 0);
}

TEST(NearestSegment, DistanceToOneSegment) {
  const Segment s{Point(0, 0, 0), Point(2, 0, 0)};
  EXPECT_EQ(distance_to(s, Point(1, 3, 4)), 5);
  EXPECT_EQ(distance_to(s, Point(-3, 4, 0)), 5);
  EXPECT_EQ(distance_to(s, Point(5, 0, 4)), 5);
  EXPECT_EQ(distance_to({s.a, s.a}, Point(0, 2, 0)), 2);
}

TEST(NearestSegment, RefusesEmptyListsAndNan) {
  EXPECT_THROW(NearestSegment({}), Error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(NearestSegment({{Point(0, 0, 0), Point(0, nan, 0)}}), Error);
}

TEST(Deviation, OfParallelLines) {
  const std::vector<Point> a{Point(0, 0, 0), Point(1, 0, 0), Point(4, 0, 0)};
  const std::vector<Point> b{Point(0, 0, 2), Point(4, 0, 2)};
  const Deviation d = deviation(a, false, b, false);
  for (const auto& side : {d.to_drawn, d.from_drawn}) {
    EXPECT_DOUBLE_EQ(side.max, 2);
    EXPECT_DOUBLE_EQ(side.mean, 2);
  }
}

TEST(Deviation, SeesACornerThatWasCut) {
  // The result cuts off a spike of height 3, whose tip is at distance 3 from the result.
  const std::vector<Point> drawn{Point(0, 0, 0), Point(5, 3, 0), Point(10, 0, 0)};
  const std::vector<Point> result{Point(0, 0, 0), Point(10, 0, 0)};
  const Deviation d = deviation(result, false, drawn, false);
  EXPECT_NEAR(d.from_drawn.max, 3, 1e-12);
  EXPECT_NEAR(d.from_drawn.mean, 1.5, 1.5e-4);
  EXPECT_EQ(d.from_drawn.at, drawn[1]);
  EXPECT_EQ(d.at, drawn[1]);
  // The largest distance of the result is in the middle of its only segment: from (5, 0) to the
  // line through (0, 0) and (5, 3).
  EXPECT_NEAR(d.to_drawn.max, 15 / std::sqrt(34.0), 1e-6 * 3);
  EXPECT_NEAR((d.to_drawn.at - Point(5, 0, 0)).norm(), 0, 1e-5);
  EXPECT_NEAR(d.to_drawn.mean, 7.5 / std::sqrt(34.0), 3e-4);
}

TEST(Deviation, FindsMaximaBetweenTheSamples) {
  // The farthest point of the base from the two flanks is at their bisector, anywhere.
  for (const double x : {0.1, 1.0 / 3, 0.7123}) {
    const std::vector<Point> base{Point(0, 0, 0), Point(1, 0, 0)};
    const std::vector<Point> posts{Point(-x, 0, 0), Point(-x, 5, 0), Point(2 - x, 5, 0),
                                   Point(2 - x, 0, 0)};
    // Distances to the posts are x + s and 2 - x - s: equal at s = 1 - x, where they are 1.
    const auto side =
        one_sided_deviation(segments_of(base, false), NearestSegment(segments_of(posts, false)));
    EXPECT_NEAR(side.max, 1, 1e-6);
    EXPECT_NEAR(side.at.x(), 1 - x, 1e-5);
    // ∫ min(x + s, 2 - x - s) ds over [0, 1].
    const double mean = (1 - x * x) / 2 + (1 - (1 - x) * (1 - x)) / 2;
    EXPECT_NEAR(side.mean, mean, 5e-4 * mean);
  }
}

TEST(Deviation, KeepsItsBoundOnRandomWalks) {
  const auto a = segments_of(random_walk(60, 3), false);
  const auto b = segments_of(random_walk(80, 4), true);
  const auto side = one_sided_deviation(a, NearestSegment(b));
  double largest = 0;
  double integral = 0;
  double length = 0;
  for (const Segment& s : a) {
    const int steps = 400;
    for (int k = 0; k < steps; ++k) {
      const double d = brute_force(b, s.a + (k + 0.5) / steps * (s.b - s.a));
      largest = std::max(largest, d);
      integral += d * (s.b - s.a).norm() / steps;
    }
    length += (s.b - s.a).norm();
  }
  EXPECT_GE(side.max, largest * (1 - 1e-6));
  EXPECT_LE(side.max, largest + 2.0 / 400);  // slope of a distance is at most 1
  EXPECT_NEAR(side.mean, integral / length, 1e-3 * side.mean);
  EXPECT_NEAR(brute_force(b, side.at), side.max, 1e-12);
}

TEST(Deviation, OfACurveFromItselfIsZero) {
  auto walk = random_walk(200, 5);
  for (Point& p : walk) p += Point(5e6, 5e6, 0);  // map coordinates
  const Deviation d = deviation(walk, true, walk, true);
  EXPECT_LT(d.to_drawn.max, 1e-8);
  // Rotated start, doubled points, reversed.
  std::vector<Point> other;
  for (std::size_t i = walk.size(); i-- > 0;) {
    const Point& p = walk[(i + 77) % walk.size()];
    other.push_back(p);
    other.push_back((p + walk[(i + 76) % walk.size()]) / 2);
  }
  const Deviation e = deviation(other, true, walk, true);
  EXPECT_LT(std::max(e.to_drawn.max, e.from_drawn.max), 1e-8);
  EXPECT_LT(std::max(e.to_drawn.mean, e.from_drawn.mean), 1e-8);
}

TEST(Deviation, ScalesWithTheMesh) {
  auto a = random_walk(50, 6);
  auto b = random_walk(50, 7);
  const Deviation big = deviation(a, false, b, true);
  for (auto* points : {&a, &b}) {
    for (Point& p : *points) p *= 1e-8;
  }
  const Deviation small = deviation(a, false, b, true);
  EXPECT_NEAR(small.to_drawn.max * 1e8, big.to_drawn.max, 2e-6 * big.to_drawn.max);
  EXPECT_NEAR(small.from_drawn.mean * 1e8, big.from_drawn.mean, 1e-9);
}

TEST(Deviation, SinglePointsAndNothing) {
  const std::vector<Point> point{Point(0, 0, 0)};
  const std::vector<Point> line{Point(-1, 2, 0), Point(1, 2, 0)};
  const Deviation d = deviation(point, false, line, false);
  EXPECT_EQ(d.to_drawn.max, 2);
  EXPECT_EQ(d.to_drawn.mean, 2);
  EXPECT_NEAR(d.from_drawn.max, std::sqrt(5.0), 1e-12);
  EXPECT_THROW(deviation({}, false, line, false), Error);
  EXPECT_THROW(deviation(line, false, {}, true), Error);
}

TEST(Deviation, AgreesWithTheReference) {
  for (const char* name : {"fandisk_14k", "aneurysm_14k", "armadillo_86k"}) {
    const auto drawn = test::reference_curve(name);
    if (!drawn) GTEST_SKIP() << test::missing(name);
    const auto numbers = test::reference_numbers(name, 1.0);
    std::vector<Point> points;
    for (const VertexId v : drawn->path) points.push_back(drawn->mesh.point(v));
    const auto result = test::reference_result(name);
    const Deviation d = deviation(result, drawn->closed, points, drawn->closed);
    const double h = numbers["mean_edge_length"];
    const double to = numbers["deviation_to_drawn_in_edge_lengths"];
    const double from = numbers["deviation_from_drawn_in_edge_lengths"];
    // The reference looks at points and midpoints and gives three digits.
    const NearestSegment tree(segments_of(points, drawn->closed));
    double sampled = 0;
    for (const Segment& s : segments_of(result, drawn->closed)) {
      for (const Point& p : {s.a, Point((s.a + s.b) / 2)}) {
        sampled = std::max(sampled, tree.to(p).distance);
      }
    }
    EXPECT_NEAR(sampled / h, to, 0.005 * to) << name;
    EXPECT_GE(d.to_drawn.max, sampled) << name;
    EXPECT_LE(d.to_drawn.max, 1.05 * sampled) << name;
    EXPECT_NEAR(d.from_drawn.max / h, from, 0.005 * from) << name;
  }
}

}  // namespace
}  // namespace talweg
