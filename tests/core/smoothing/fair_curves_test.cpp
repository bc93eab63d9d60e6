// Fair curves are round, keep to their walls and their pins, and bend little.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg::fair_curves_test {
namespace {

constexpr double kPi = std::numbers::pi;

constexpr double kFive = 5 * kPi / 180;

/// The largest distance of a curve's points and the middles of its segments from a drawing.
double farthest(const SurfaceMesh& mesh, const SurfaceCurve& curve, const SurfaceCurve& drawn) {
  PolylineDistance distance(mesh.surface());
  distance.set(std::span(&drawn, 1));
  double most = 0;
  for (const SurfacePoint& p : curve.points) most = std::max(most, distance.at(p).distance);
  return most;
}

double bending(const SurfaceMesh& mesh, const SurfaceCurve& curve, double edge) {
  return measure_curve(mesh.surface(), curve, edge).bending;
}

// A zigzag around a circle of the plane: the fair loop is the circle, up to the width of the walls.
TEST(FairCurve, OfAJaggedCircleIsRoundAndOfItsSize) {
  const auto opened = OpenedMesh::open(test::grid(60, 60));
  for (const double radius : {6.0, 12.0, 22.0}) {
    const SurfaceCurve drawn = test::drawn_near(
        opened->mesh(), test::circle({30, 30, 0}, {radius, 0, 0}, {0, radius, 0}, 24), true);
    const SmoothingResult result = smooth_curve(opened, drawn, {});
    double most = 0, least = HUGE_VAL;
    for (const Point& p : positions_of(opened->mesh(), result.curve())) {
      most = std::max(most, (p - Point(30, 30, 0)).norm());
      least = std::min(least, (p - Point(30, 30, 0)).norm());
    }
    EXPECT_LT(most - least, 0.6 + 0.1 * radius) << radius;
    EXPECT_NEAR((most + least) / 2, radius, 0.6) << radius;
    EXPECT_NEAR(result.report().after.total_curvature, 2 * kPi, 0.5) << radius;
    EXPECT_LT(result.report().after.max_curvature, kFive) << radius;
    // A circle bends by h 2 pi / r.
    EXPECT_LT(result.report().after.bending, 1.5 * 2 * kPi / radius) << radius;
  }
}

TEST(FairCurve, KeepsToItsWallsForEveryTau) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const double slack = smoother.slack()[0];
  double last = HUGE_VAL;
  for (const double tau : {0.125, 0.3, 0.5, 1.0, 1.7, 3.0, 8.0, 100.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    const double far = farthest(opened->mesh(), result.curve(), drawn);
    EXPECT_LE(far, (1.25 + 0.25 / tau) * slack * (1 + 1e-9)) << tau;
    EXPECT_LE(far, last + 0.05 * result.report().edge_length_near) << tau;
    last = far;
    EXPECT_LT(result.report().after.max_curvature, kFive) << tau;
    EXPECT_TRUE(result.report().warnings.empty()) << result.report().warnings.front();
  }
}

TEST(FairCurve, BendsMuchLessThanTheTautOneAndNoMoreAtAnyPoint) {
  const auto opened = OpenedMesh::open(test::sphere(5));
  const SurfaceMesh& mesh = opened->mesh();
  const SurfaceCurve drawn =
      test::drawn_near(mesh, test::circle({0, 0, 0.5}, {0.8, 0.1, 0}, {0, 0.8, 0.1}, 24), true);
  SmoothingOptions taut;
  taut.finish = Finish::kTaut;
  const SmoothingResult straight = smooth_curve(opened, drawn, taut);
  const SmoothingResult fair = smooth_curve(opened, drawn, {});
  const double edge = fair.report().edge_length_near;
  EXPECT_LT(bending(mesh, fair.curve(), edge), 0.5 * bending(mesh, straight.curve(), edge));
  EXPECT_GT(straight.report().after.max_curvature, 2 * kFive);
  EXPECT_LT(fair.report().after.max_curvature, kFive);
}

// The drawing runs around three sides of a square that is far larger than its slack.
TEST(FairCurve, GoesWhereTheDrawingGoes) {
  const auto opened = OpenedMesh::open(test::grid(60, 60));
  const Point corners[] = {{5, 30, 0},  {25, 30, 0}, {25, 45, 0},
                           {35, 45, 0}, {35, 30, 0}, {55, 30, 0}};
  const SurfaceCurve drawn = test::drawn_near(opened->mesh(), corners, false);
  const SmoothingResult result = smooth_curve(opened, drawn, {});
  EXPECT_LT(result.report().deviation_from_drawn_max, 3 * result.report().slack);
  EXPECT_LT(result.report().after.max_curvature, kFive);
  EXPECT_EQ(result.curve().points.front(), drawn.points.front());
  EXPECT_EQ(result.curve().points.back(), drawn.points.back());
}

TEST(FairCurve, PassesItsPinsWithoutAKink) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  const std::vector<SurfacePoint> pins{drawn.points[9], drawn.points[20]};
  const SmoothingResult result = smooth_curve(opened, drawn, {}, {.pins = pins});
  const auto& points = result.curve().points;
  for (const SurfacePoint& pin : pins) {
    const auto at = std::find(points.begin(), points.end(), pin);
    ASSERT_NE(at, points.end());
    ASSERT_NE(at, points.begin());
    EXPECT_LT(turning_angle(opened->surface(), *(at - 1), *at, *(at + 1)), 2 * kFive);
  }
}

TEST(FairCurve, StrandsBesideEachOtherDoNotCross) {
  const auto opened = OpenedMesh::open(test::grid(60, 60));
  std::vector<SurfaceCurve> curves;
  for (const double y : {20.0, 21.0, 22.0}) {
    std::vector<Point> points;
    for (int i = 0; i <= 25; ++i) {
      points.emplace_back(5 + 2 * i, y + (i % 2 == 0 ? 0.0 : 1.0), 0);
    }
    curves.push_back(test::drawn_near(opened->mesh(), points, false));
  }
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  for (const double tau : {0.125, 0.5, 1.0, 4.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    EXPECT_TRUE(crossing_curves(opened->surface(), result.curves).empty()) << tau;
  }
}

}  // namespace
}  // namespace talweg::fair_curves_test
