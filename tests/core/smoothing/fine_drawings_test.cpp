// Drawings finer than the mesh are smoothed as on a mesh of their fineness.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg::fine_drawings_test {
namespace {

using namespace test;

constexpr double kStraightAngle = std::numbers::pi;

/// A wave that trembles by `off` from point to point.
std::vector<Point> wave(std::size_t count, double off) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    points.emplace_back(0.55 + 6.9 * t, 4 + 1.5 * std::sin(9 * t) + (i % 2 == 0 ? off : -off), 0);
  }
  return points;
}

std::vector<Point> ring(int count, double off) {
  std::vector<Point> points = circle(Point(3.3, 3.7, 0), Point(2.1, 0, 0), Point(0, 2.1, 0), count);
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] += Point(off, off, 0);
  return points;
}

TEST(FineDrawings, GiveTheSameOnMeshesOfAnyResolution) {
  for (const bool closed : {false, true}) {
    const std::vector<Point> points = closed ? ring(160, 0.08) : wave(161, 0.06);
    const auto reference = OpenedMesh::open(sheet(1));
    std::vector<SurfaceCurve> results;
    for (const std::uint32_t count : {1U, 3U, 8U}) {
      const auto opened = OpenedMesh::open(sheet(count));
      const SurfaceCurve drawn = straight_through(opened->mesh(), points, closed);
      CurveSmoother smoother(opened);
      smoother.set_curve(drawn);
      const double slack = smoother.slack().front();
      const SmoothingResult result = smoother.smooth(1.0);
      EXPECT_EQ(result.report().engine, Engine::kRefined) << count;
      EXPECT_LT(result.report().deviation_to_drawn_max, 2 * slack) << count;
      EXPECT_LT(result.report().deviation_from_drawn_max, 2.6 * slack) << count;
      EXPECT_LT(result.report().after.total_curvature, closed ? 8 : 7.5) << count;
      EXPECT_TRUE(result.report().warnings.empty()) << result.report().warnings.front();
      results.push_back(straight_through(reference->mesh(),
                                         positions_of(opened->mesh(), result.curve()), closed));
      EXPECT_LT(apart(reference->mesh(), results.front(), results.back()), 0.5 * slack) << count;
    }
  }
}

TEST(FineDrawings, CostAboutTheirPointsNotTheirSquare) {
  const auto opened = OpenedMesh::open(sheet(1));
  std::vector<double> flips;
  for (const std::size_t count : {1000U, 8000U}) {
    CurveSmoother smoother(opened);
    smoother.set_curve(
        straight_through(opened->mesh(), wave(count, 30.0 / static_cast<double>(count)), false));
    flips.push_back(
        static_cast<double>(smoother.smooth({.tau = 1, .finish = Finish::kTaut}).report().flips));
  }
  EXPECT_LT(flips[1], 24 * flips[0]);  // without division, 64 times as many and more
}

TEST(FineDrawings, GeodesicsStayStraight) {
  const auto opened = OpenedMesh::open(sheet(2));
  const SurfaceCurve drawn = straight_through(opened->mesh(), wave(200, 0.05), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult result = smoother.smooth(0.0);
  const Point ends =
      opened->mesh().position(drawn.points.front()) - opened->mesh().position(drawn.points.back());
  EXPECT_NEAR(result.report().after.length, ends.norm(), 1e-9);
  EXPECT_LT(result.report().after.total_curvature, 1e-6);
}

TEST(FineDrawings, ResultsDoNotDependOnEarlierCalls) {
  const auto opened = OpenedMesh::open(sheet(2));
  const SurfaceCurve drawn = straight_through(opened->mesh(), wave(200, 0.05), false);
  CurveSmoother smoother(opened), other(opened);
  smoother.set_curve(drawn);
  other.set_curve(drawn);
  other.smooth(0.01);
  other.smooth(16);
  EXPECT_EQ(smoother.smooth(1.5).curve().points, other.smooth(1.5).curve().points);
}

TEST(FineDrawings, FromTheOtherEndGiveTheSameTurnedRound) {
  const auto opened = OpenedMesh::open(sheet(2));
  std::vector<Point> points = wave(200, 0.05);
  const SurfaceCurve drawn = straight_through(opened->mesh(), points, false);
  std::reverse(points.begin(), points.end());
  const SurfaceCurve turned = straight_through(opened->mesh(), points, false);
  const SmoothingResult one = smooth_curve(opened, drawn), other = smooth_curve(opened, turned);
  EXPECT_LT(apart(opened->mesh(), one.curve(), other.curve()), 1e-9);
  EXPECT_LT((opened->mesh().position(one.curve().points.front()) -
             opened->mesh().position(other.curve().points.back()))
                .norm(),
            1e-12);
}

TEST(FineDrawings, PassTheirPins) {
  const auto opened = OpenedMesh::open(sheet(1));
  const SurfaceCurve drawn = straight_through(opened->mesh(), wave(101, 0.2), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const std::vector<SurfacePoint> pins = {drawn.points[30], drawn.points[61]};
  smoother.set_pins(pins);
  const SmoothingResult set_later = smoother.smooth(1.0);
  CurveOptions options;
  options.pins = pins;
  smoother.set_curve(drawn, options);
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_EQ(set_later.curve().points, result.curve().points);
  for (const SurfacePoint& pin : pins) {
    double nearest = HUGE_VAL;
    for (const SurfacePoint& p : result.curve().points) {
      nearest =
          std::min(nearest, (opened->mesh().position(p) - opened->mesh().position(pin)).norm());
    }
    EXPECT_LT(nearest, 1e-12);
  }
}

TEST(FineDrawings, FollowASlackAlongTheDrawing) {
  const auto opened = OpenedMesh::open(sheet(1));
  const SurfaceCurve drawn = straight_through(opened->mesh(), wave(161, 0.06), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  SmoothingOptions options;
  options.tau = 4;
  std::vector<double> slack(drawn.points.size(), 0.6);
  std::fill_n(slack.begin(), slack.size() / 2, 0.08);
  options.slack_at = {slack};
  const SurfaceCurve result = smoother.smooth(options).curve();
  double tight = 0, loose = 0;
  PolylineDistance distance(opened->surface());
  distance.set(std::span(&drawn, 1));
  for (const SurfacePoint& p : result.points) {
    double& most = opened->mesh().position(p).x() < 3.5 ? tight : loose;
    most = std::max(most, distance.at(p).distance);
  }
  EXPECT_LT(tight, 0.2);
  EXPECT_GT(loose, 1.1 * tight);
  options.slack_at = {{1, 2, 3}};
  EXPECT_THROW(smoother.smooth(options), Error);
}

TEST(FineDrawings, StayWithinABound) {
  const auto opened = OpenedMesh::open(sheet(1));
  const SurfaceCurve drawn = straight_through(opened->mesh(), wave(161, 0), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult result = smooth_within(smoother, 0.1);
  EXPECT_EQ(result.report().termination, Outcome::kConverged);
  EXPECT_LE(result.report().deviation_to_drawn_max, 0.1);
  EXPECT_LE(result.report().deviation_from_drawn_max, 0.1);
  // The drawing is smooth, so division would gain nothing.
  EXPECT_LE(result.report().after.total_curvature, 1.1 * result.report().before.total_curvature);
}

TEST(FineDrawings, KeepTheirCrossings) {
  const auto opened = OpenedMesh::open(sheet(1));
  std::vector<Point> points;
  for (std::size_t k = 0; k < 200; ++k) {
    const double t = 2 * kStraightAngle * (static_cast<double>(k) + 0.5) / 200;
    points.push_back(Point(4.2, 3.9, 0) + 3 * Point(std::sin(t), std::sin(t) * std::cos(t), 0) +
                     Point(k % 2 == 0 ? 0.05 : 0, 0, 0));
  }
  const SurfaceCurve drawn = straight_through(opened->mesh(), points, true);
  const SmoothingReport report = smooth_curve(opened, drawn).report();
  EXPECT_EQ(report.crossings_before, 1U);
  EXPECT_EQ(report.crossings_after, 1U);
  EXPECT_LT(report.after.total_curvature, report.before.total_curvature / 4);
}

TEST(FineDrawings, OfASetDoNotCross) {
  const auto opened = OpenedMesh::open(sheet(1));
  std::vector<Point> above = wave(161, 0.06);
  for (Point& p : above) p.y() += 0.3;
  const std::vector<SurfaceCurve> drawn = {straight_through(opened->mesh(), wave(161, 0.06), false),
                                           straight_through(opened->mesh(), above, false)};
  CurveSmoother smoother(opened);
  smoother.set_curves(drawn);
  const SmoothingResult result = smoother.smooth(1.0);
  ASSERT_EQ(result.curves.size(), 2U);
  EXPECT_TRUE(crossing_curves(opened->surface(), result.curves).empty());
  EXPECT_GT(DeviationMeter(opened->mesh())
                .measure(std::span(&result.curves[0], 1), std::span(&result.curves[1], 1))
                .larger()
                .max,
            0.05);
}

// For tau < 1/8 a result may be anywhere; only the faces that it reaches are divided, not the faces
// beyond.
TEST(FineDrawings, CostDependsOnTheResultNotOnTheMesh) {
  const auto asked_on = [](std::uint32_t count) {
    MeshLists lists = grid(count, count);
    for (Point& p : lists.points) p *= 2;  // the sheet of 4 x 4 squares and more around it
    const auto opened = OpenedMesh::open(lists);
    CurveSmoother smoother(opened);
    smoother.set_curve(straight_through(opened->mesh(), wave(161, 0.06), false));
    std::size_t asked = 0;
    SmoothingOptions options;
    options.tau = 0.05;
    const Progress progress = [&](const char*, double) { return ++asked > 0; };
    EXPECT_EQ(smoother.smooth(options, progress).report().engine, Engine::kRefined);
    return asked;
  };
  const std::size_t few = asked_on(40), many = asked_on(600);
  EXPECT_GT(few, 0U);
  EXPECT_LE(many, few + few / 4);
}

// The chord of a semicircle is farther from it than any result for tau >= 1/8. A part of the mesh
// with twice the reach is therefore divided, not the whole mesh.
TEST(FineDrawings, ThatLeadFarAreFollowed) {
  const auto opened = OpenedMesh::open(grid(300, 300));
  const Point centre(150.3, 80.2, 0);
  std::vector<Point> points = circle(centre, Point(100, 0, 0), Point(0, 100, 0), 800);
  points.resize(401);
  // Too many points for one face, at the top, where the hand is slow.
  std::vector<Point> trembling;
  for (int i = 0; i < 100; ++i) {
    trembling.push_back(points[200] + Point(0.005 * (50 - i), i % 2 == 0 ? 0.02 : -0.02, 0));
  }
  points.insert(points.erase(points.begin() + 200), trembling.begin(), trembling.end());
  CurveSmoother smoother(opened);
  smoother.set_curve(straight_through(opened->mesh(), points, false));
  std::size_t dividing = 0;
  SmoothingOptions options;
  options.tau = 0;
  const Progress progress = [&](const char* stage, double) {
    if (std::string(stage) == "solve") ++dividing;
    return true;
  };
  const SmoothingResult result = smoother.smooth(options, progress);
  ASSERT_EQ(result.report().engine, Engine::kRefined);
  EXPECT_GT(dividing, 0U);
  EXPECT_NEAR(result.report().after.length, 200, 1e-9);
  EXPECT_LT(result.report().after.total_curvature, 1e-6);
}

TEST(FineDrawings, CanBeDragged) {
  const auto opened = OpenedMesh::open(sheet(1));
  std::vector<Point> points = wave(161, 0.06);
  const SurfaceCurve drawn = straight_through(opened->mesh(), points, false);
  for (std::size_t k = 70; k < 90; ++k) points[k].y() += 0.4;
  const SurfaceCurve moved = straight_through(opened->mesh(), points, false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult preview = smoother.drag(0, moved);
  EXPECT_EQ(preview.report().engine, Engine::kPreview);
  EXPECT_LT(apart(opened->mesh(), preview.curve(), smooth_curve(opened, moved).curve()), 1e-9);
}

TEST(FineDrawings, TakeAPotentialOfTheCaller) {
  const auto opened = OpenedMesh::open(sheet(4));
  const SurfaceCurve drawn = straight_through(opened->mesh(), wave(161, 0.06), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const std::vector<double> flat(opened->surface().vertex_count(), 3.0);
  const SmoothingResult result = smoother.smooth({}, flat, 1);
  EXPECT_EQ(result.report().potential, PotentialKind::kCustom);
  EXPECT_LT(result.report().after.total_curvature, 1e-6);  // a constant potential gives geodesics
}

}  // namespace
}  // namespace talweg::fine_drawings_test
