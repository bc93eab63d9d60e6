// Near clicks are merged: a double click means one point.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg::near_clicks_test {
namespace {

class NearClicks : public testing::Test {
 protected:
  using Clicks = std::vector<std::array<double, 2>>;
  [[nodiscard]] Drawing drawn(const Clicks& clicks, bool closed) const {
    std::vector<Point> points;
    for (const auto& [x, y] : clicks) points.emplace_back(x, y, 0);
    const SnappedCurve snapped = snap(opened->mesh(), {closed, points, {}});
    DrawOptions options;
    options.closed = closed;
    return draw(opened->surface(), snapped.points, options);
  }
  SmoothingResult smoothed(const Clicks& clicks, bool closed, const CurveOptions& options = {}) {
    smoother.set_curve(drawn(clicks, closed), options);
    return smoother.smooth(1);
  }
  /// The distance of the result from a click.
  [[nodiscard]] double missed(const SmoothingResult& result, double x, double y) const {
    const std::vector<Point> at{Point(x, y, 0), Point(x, y, 0)};
    return deviation(at, false, positions_of(opened->mesh(), result.curve()), result.curve().closed)
        .to_drawn.max;
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(24, 24));
  CurveSmoother smoother{opened};
};

const std::vector<std::array<double, 2>> kRing{{22, 12}, {19.07, 19.07}, {12, 22}, {4.93, 19.07},
                                               {2, 12},  {4.93, 4.93},   {12, 2},  {19.07, 4.93}};

TEST_F(NearClicks, ADoubleClickIsOne) {
  const SmoothingResult once = smoothed(kRing, true);
  for (const double beside : {1e-3, 0.3, 1.0}) {
    auto twice = kRing;
    twice.insert(twice.begin() + 4, {kRing[3][0] - beside, kRing[3][1]});
    const SmoothingResult result = smoothed(twice, true);
    EXPECT_EQ(result.report().termination, Outcome::kConverged) << beside;
    EXPECT_LT(result.report().after.bending, 1.2 * once.report().after.bending) << beside;
    ASSERT_EQ(result.report().warnings.size(), 1U) << beside;
    EXPECT_NE(result.report().warnings[0].find("merged with that point"), std::string::npos);
    for (const auto& [x, y] : kRing) EXPECT_LT(missed(result, x, y), 1.1 * beside) << beside;
  }
}

TEST_F(NearClicks, ALoopMayBeClosedByAClickBesideTheFirst) {
  auto ring = kRing;
  ring.push_back({22.35, 13.04});
  const SmoothingResult result = smoothed(ring, true);
  EXPECT_LT(result.report().after.bending, 1.2 * smoothed(kRing, true).report().after.bending);
  EXPECT_GT(result.report().after.length, 61);
  for (const auto& [x, y] : kRing) EXPECT_LT(missed(result, x, y), 1.1);
}

TEST_F(NearClicks, AllAreKeptIfTheDistanceIsZero) {
  auto twice = kRing;
  twice.insert(twice.begin() + 4, {kRing[3][0] - 0.8, kRing[3][1]});
  CurveOptions options;
  options.click_distance = 0;
  const SmoothingResult result = smoothed(twice, true, options);
  EXPECT_EQ(result.report().termination, Outcome::kConverged);
  EXPECT_TRUE(result.report().warnings.empty()) << result.report().warnings.front();
  for (const auto& [x, y] : twice) EXPECT_LT(missed(result, x, y), 1e-6);
  // Far from the double click, the result is a circle of radius 10 about (12, 12).
  std::size_t far = 0;
  for (const Point& p : positions_of(opened->mesh(), result.curve())) {
    if (p.x() <= 12) continue;
    ++far;
    EXPECT_NEAR((p - Point(12, 12, 0)).norm(), 10, 0.6);
  }
  EXPECT_GT(far, 10U);
}

TEST_F(NearClicks, ClicksThatAreAllNearAreAllKept) {
  std::vector<std::array<double, 2>> line;
  for (int k = 0; k < 12; ++k) line.push_back({6.0 + k, 12 + 0.5 * std::sin(k)});
  const SmoothingResult result = smoothed(line, false);
  for (const auto& [x, y] : line) EXPECT_LT(missed(result, x, y), 1e-6);
}

TEST_F(NearClicks, TheirDistanceIsAnOption) {
  CurveOptions options;
  options.click_distance = -1;
  EXPECT_THROW(smoothed(kRing, true, options), Error);
  options.click_distance = 3;
  auto twice = kRing;
  twice.insert(twice.begin() + 4, {kRing[3][0] - 2.5, kRing[3][1]});
  EXPECT_EQ(smoothed(twice, true, options).report().warnings.size(), 1U);
  EXPECT_TRUE(smoothed(twice, true).report().warnings.empty());
}

/// Between the second and the third click the drawing goes up and comes back.
TEST_F(NearClicks, AClickToWhichTheDrawingComesBackIsNoSecondOne) {
  for (const double beside : {0.0, 0.4}) {
    const std::vector<Point> points{{4, 4, 0},  {12, 4, 0},          {16, 10, 0},
                                    {8, 10, 0}, {12 - beside, 4, 0}, {20, 2, 0}};
    const SnappedCurve snapped = snap(opened->mesh(), {false, points, {}});
    StraightLines lines(opened->surface());
    CurveOptions options;
    for (const std::size_t k : {0, 1, 4, 5}) options.way_points.push_back({snapped.points[k], 0});
    smoother.set_curve(lines.join(snapped.points, false), options);
    const SmoothingResult result = smoother.smooth(1);
    for (const WayPoint& way : options.way_points) {
      const Point at = opened->mesh().position(way.point);
      EXPECT_LT(missed(result, at.x(), at.y()), 1e-6) << beside << ": " << at.transpose();
    }
  }
}

/// Where the drawing passes the second click again, clicks lie beside it, before and after: the
/// drawing may be walked from either end.
TEST_F(NearClicks, AClickThatIsPassedTwiceStaysThoughAnotherIsBesideIt) {
  const std::vector<Point> points{{4, 4, 0},    {12, 4, 0}, {16, 10, 0},    {8, 10, 0},
                                  {11.7, 4, 0}, {12, 4, 0}, {12.3, 3.8, 0}, {20, 2, 0}};
  const SnappedCurve snapped = snap(opened->mesh(), {false, points, {}});
  StraightLines lines(opened->surface());
  CurveOptions options;
  for (const std::size_t k : {0, 1, 2, 3, 4, 6, 7}) {
    options.way_points.push_back({snapped.points[k], 0});
  }
  smoother.set_curve(lines.join(snapped.points, false), options);
  EXPECT_LT(missed(smoother.smooth(1), 12, 4), 1e-6);
}

/// Way-points do not define the way between them, so the way may cross itself.
TEST_F(NearClicks, LegsThatCrossAreAsRoundAsOthers) {
  const std::vector<std::array<double, 2>> eight{{16, 16}, {21, 15}, {21, 9}, {16, 8},
                                                 {8, 16},  {3, 15},  {3, 9},  {8, 8}};
  const SmoothingResult result = smoothed(eight, true);
  EXPECT_EQ(result.report().crossings_before, 1U);
  EXPECT_EQ(result.report().crossings_after, 1U);
  EXPECT_LT(result.report().after.max_curvature, 0.1);
  EXPECT_LT(result.report().after.length, 1.1 * result.report().before.length);
  for (const auto& [x, y] : eight) EXPECT_LT(missed(result, x, y), 1e-6);
}

}  // namespace
}  // namespace talweg::near_clicks_test
