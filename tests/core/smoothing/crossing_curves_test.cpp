// Curves that cross or touch themselves and each other are smoothed, and keep their crossings.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using namespace test;

constexpr double kPi = std::numbers::pi;

/// Every third position is moved off by this much, to and fro.
void shake(std::vector<Point>& points, const Point& off) {
  for (std::size_t k = 0; k < points.size(); k += 3) points[k] += k % 2 == 0 ? off : Point(-off);
}

std::vector<Point> eight(const Point& centre, double size, std::size_t count) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 2 * kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    points.push_back(centre + size * Point(std::sin(t), std::sin(t) * std::cos(t), 0));
  }
  return points;
}

TEST(CrossingCurves, AFigureEightKeepsItsCrossing) {
  const auto opened = OpenedMesh::open(hills(40));
  std::vector<Point> points = eight(Point(20, 20, 0), 14, 90);
  shake(points, Point(0, 0.7, 0));
  const SurfaceCurve drawn = straight_through(opened->mesh(), points, true);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : {0.25, 1.0, 4.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    const SmoothingReport& report = result.report();
    EXPECT_EQ(report.crossings_before, 1U);
    EXPECT_EQ(report.crossings_after, 1U);
    EXPECT_EQ(report.termination, Outcome::kConverged);
    EXPECT_LT(report.after.total_curvature, report.before.total_curvature / 4) << tau;
    EXPECT_LT(apart(opened->mesh(), drawn, result.curve()), tau < 1 ? 5 : 3) << tau;
  }
}

TEST(CrossingCurves, InThePlaneAFigureEightTurnsLittleMoreThanItMust) {
  const auto opened = OpenedMesh::open(grid(60, 60));
  std::vector<Point> points = eight(Point(30.2, 30.3, 0), 22, 120);
  shake(points, Point(0, 0.6, 0));
  CurveSmoother smoother(opened);
  smoother.set_curve(straight_through(opened->mesh(), points, true));
  const SmoothingReport report = smoother.smooth(2.0).report();
  // Each loop of the figure eight turns by 3 pi / 2, because the curve crosses itself at a right
  // angle.
  EXPECT_LT(report.after.total_curvature, 1.1 * 3 * kPi);
  EXPECT_GT(report.after.total_curvature, 0.9 * 3 * kPi);
  EXPECT_EQ(report.crossings_after, 1U);
}

TEST(CrossingCurves, TwiceAroundATube) {
  const auto opened = OpenedMesh::open(tube(48, 60, 8));
  CurveSmoother smoother(opened);
  smoother.set_curve(straight_through(opened->mesh(), twice_around(), true));
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_EQ(result.report().crossings_before, 1U);
  EXPECT_EQ(result.report().crossings_after, 1U);
  EXPECT_LT(result.report().after.total_curvature, result.report().before.total_curvature / 5);
  EXPECT_GT(result.report().after.length, 0.98 * 4 * kPi);
}

bool warns_of(const SmoothingReport& report, const char* words) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

// The strip grows until it contains the result, however far this is from the drawing.
TEST(CrossingCurves, ALegFarFromItsDrawingIsStraight) {
  const auto opened = OpenedMesh::open(grid(60, 60));
  const Surface& surface = opened->surface();
  const std::array curves = {
      vertex_curve(surface, along_grid(61, {{{5, 5}, {5, 35}, {45, 35}, {45, 5}}}), false),
      vertex_curve(surface, along_grid(61, {{{25, 20}, {25, 50}}}), false)};
  CurveOptions options;
  for (const SurfaceCurve& curve : curves) {
    options.way_points.push_back({curve.points.front()});
    options.way_points.push_back({curve.points.back()});
  }
  CurveSmoother smoother(opened);
  smoother.set_curves(curves, options);
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_EQ(result.total.crossings_before, 1U);
  EXPECT_EQ(result.total.crossings_after, 0U);
  EXPECT_TRUE(warns_of(result.total, "crosses itself and other curves once, the result nowhere."));
  EXPECT_NEAR(result.reports[0].after.length, 40, 1e-9);
  EXPECT_NEAR(result.reports[1].after.length, 30, 1e-9);
}

TEST(CrossingCurves, CurvesThatCrossAreSmoothedAsIfAlone) {
  const auto opened = OpenedMesh::open(hills(40));
  const SurfaceCurve wave = wave_on_hills(opened->mesh());
  const std::array<Point, 4> down = {Point(17, 4, 0), Point(22, 14, 0), Point(18, 26, 0),
                                     Point(23, 36, 0)};
  const std::array curves = {wave, drawn_near(opened->mesh(), down, false)};
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_EQ(result.total.crossings_before, 1U);
  EXPECT_EQ(result.total.crossings_after, 1U);
  for (std::size_t c = 0; c < 2; ++c) {
    const SmoothingResult alone = smooth_curve(opened, curves[c]);
    EXPECT_LT(apart(opened->mesh(), result.curves[c], alone.curve()), 1e-6);
    EXPECT_EQ(result.reports[c].points_before, alone.report().points_before);
  }
}

TEST(CrossingCurves, SpikesGoAndEndsStay) {
  const auto opened = OpenedMesh::open(grid(12, 12));
  // Along a row, up a column of it and back the same way, and on.
  const auto way = ids({66, 67, 68, 81, 94, 81, 68, 69, 70, 71, 70, 71, 72});
  const SurfaceCurve drawn = vertex_curve(opened->surface(), way, false);
  const SmoothingResult result = smooth_curve(opened, drawn);
  EXPECT_EQ(result.curve().points.front(), drawn.points.front());
  EXPECT_EQ(result.curve().points.back(), drawn.points.back());
  EXPECT_NEAR(result.report().after.length, 6, 1e-6);
  EXPECT_EQ(result.report().crossings_before, 0U);
}

// Along a stem to a figure eight, around it, and back along the stem to where it began.
TEST(CrossingCurves, AnEndOnASpikeThatGoesStays) {
  const auto opened = OpenedMesh::open(hills(40));
  std::vector<Point> points{Point(20, 2, 0), Point(20, 10, 0)};
  for (const Point& p : eight(Point(20, 20, 0), 12, 48)) points.push_back(p);
  points.push_back(points[1]);
  points.push_back(points[0]);
  const SurfaceCurve drawn = straight_through(opened->mesh(), points, false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : {0.0, 0.25, 1.0, 4.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    EXPECT_FALSE(result.curve().closed);
    EXPECT_EQ(result.curve().points.front(), drawn.points.front()) << tau;
    EXPECT_EQ(result.curve().points.back(), drawn.points.back()) << tau;
    EXPECT_GT(result.report().after.length, result.report().before.length / 2) << tau;
  }
}

TEST(CrossingCurves, APinOnASpikeIsLostAndTold) {
  const auto opened = OpenedMesh::open(grid(12, 12));
  const auto way = ids({66, 67, 68, 81, 94, 81, 68, 69, 70, 71});
  const SurfaceCurve drawn = vertex_curve(opened->surface(), way, false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn, {.pins = {drawn.points[1], drawn.points[4]}});
  const SmoothingReport report = smoother.smooth(1.0).report();
  EXPECT_TRUE(warns_of(report, "The result misses the pin (vertex 94) at (3, 7, 0)"));
  EXPECT_FALSE(warns_of(report, "vertex 67"));
  smoother.set_pins(std::array{drawn.points[1], drawn.points[2]});
  EXPECT_FALSE(warns_of(smoother.smooth(1.0).report(), "misses the pin"));
}

TEST(CrossingCurves, TouchingItselfAtAVertexIsNoCrossing) {
  const auto opened = OpenedMesh::open(grid(16, 16));
  std::vector<Point> points;  // two loops side by side, that meet at (8, 8)
  for (const int side : {-1, 1}) {
    for (int k = 0; k < 24; ++k) {
      const double t = 2 * kPi * k / 24;
      points.emplace_back(8 + side * 3.5 * (1 - std::cos(t)), 8 - side * 3.5 * std::sin(t), 0);
    }
  }
  const SurfaceCurve drawn = straight_through(opened->mesh(), points, true);
  const SmoothingReport report = smooth_curve(opened, drawn).report();
  EXPECT_EQ(report.crossings_before, 0U);
  EXPECT_LT(report.after.total_curvature, report.before.total_curvature * 1.01);
  EXPECT_LT(report.deviation_to_drawn_max, 2);
}

TEST(CrossingCurves, TheSameFromBothEndsAndWithThePapersMethod) {
  const auto opened = OpenedMesh::open(hills(40));
  std::vector<Point> points = eight(Point(20, 20, 0), 14, 90);
  const SurfaceCurve drawn = straight_through(opened->mesh(), points, true);
  SurfaceCurve turned = drawn;
  std::reverse(turned.points.begin(), turned.points.end());
  const SurfaceCurve one = smooth_curve(opened, drawn).curve();
  EXPECT_LT(apart(opened->mesh(), one, smooth_curve(opened, turned).curve()), 1e-6);

  const SmoothingResult papers =
      smooth_curve(opened, drawn, {.tau = 1}, {.method = Method::kPaper});
  EXPECT_EQ(papers.report().crossings_after, 1U);
  EXPECT_LE(papers.report().lifted_length_after, papers.report().lifted_length_before);
}

TEST(CrossingCurves, DraggedAndHeldByPins) {
  const auto opened = OpenedMesh::open(hills(40));
  const SurfaceCurve drawn =
      straight_through(opened->mesh(), eight(Point(20, 20, 0), 14, 60), true);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const std::array pins = {drawn.points[drawn.points.size() / 8]};
  smoother.set_pins(pins);
  const SurfaceCurve held = smoother.smooth(0.5).curve();
  EXPECT_NE(std::find(held.points.begin(), held.points.end(), pins[0]), held.points.end());

  const SurfaceCurve moved =
      straight_through(opened->mesh(), eight(Point(21, 20, 0), 14, 60), true);
  const SmoothingResult preview = smoother.drag(0, moved);
  EXPECT_EQ(preview.report().engine, Engine::kPreview);
  EXPECT_EQ(preview.report().crossings_after, 1U);
}

}  // namespace
}  // namespace talweg
