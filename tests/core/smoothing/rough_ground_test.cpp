// On rough meshes curves are fair when seen from outside.
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "core/rough_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::roughened;

constexpr int kLevels = 6;  // 16,386 vertices, edges of 0.03

std::shared_ptr<const OpenedMesh> rough_sphere(double rough) {
  MeshLists lists = test::sphere(kLevels);
  const double h = SurfaceMesh::open(lists).mean_edge_length();
  return OpenedMesh::open(rough > 0 ? roughened(std::move(lists), rough * h) : lists);
}

/// Clicks around the equator, alternately above and below it.
std::vector<VertexId> clicks() {
  const MeshLists lists = test::sphere(kLevels);
  std::vector<VertexId> result;
  for (int k = 0; k < 6; ++k) {
    const double angle = 1.047 * k;
    const Point at =
        Point(std::cos(angle), std::sin(angle), k % 2 == 0 ? 0.25 : -0.25).normalized();
    std::size_t nearest = 0;
    for (std::size_t v = 1; v < lists.points.size(); ++v) {
      if ((lists.points[v] - at).norm() < (lists.points[nearest] - at).norm()) nearest = v;
    }
    result.emplace_back(nearest);
  }
  return result;
}

SmoothingResult clicked(const std::shared_ptr<const OpenedMesh>& opened) {
  std::vector<SurfacePoint> points;
  for (const VertexId v : clicks()) points.push_back(SurfacePoint::at_vertex(opened->surface(), v));
  CurveSmoother smoother(opened);
  DrawOptions options;
  options.closed = true;
  smoother.set_curve(draw(opened->surface(), points, options));
  return smoother.smooth();
}

/// The positions of the same points of faces on the sphere without noise.
std::vector<Point> without_noise(const SurfaceCurve& curve) {
  static const SurfaceMesh smooth = SurfaceMesh::open(test::sphere(kLevels));
  std::vector<Point> places;
  for (const SurfacePoint& p : curve.points) places.push_back(smooth.position(p).normalized());
  return places;
}

double farthest(const std::vector<Point>& from, const std::vector<Point>& to) {
  double most = 0;
  for (const Point& p : from) {
    double least = HUGE_VAL;
    for (const Point& q : to) least = std::min(least, (p - q).norm());
    most = std::max(most, least);
  }
  return most;
}

TEST(RoughGround, AClickedLoopIsThatOfTheSmoothSurface) {
  const SmoothingResult smooth = clicked(rough_sphere(0));
  const std::vector<Point> expected = without_noise(smooth.curves[0]);
  const double h = smooth.reports[0].edge_length_near;
  for (const double rough : {0.1, 0.3, 0.5}) {
    const auto opened = rough_sphere(rough);
    const SmoothingResult result = clicked(opened);
    const std::vector<Point> places = without_noise(result.curves[0]);
    EXPECT_LT(farthest(places, expected), (rough + 0.75) * h) << rough;
    EXPECT_LT(farthest(expected, places), (rough + 0.75) * h) << rough;
    EXPECT_LT(result.reports[0].after.bending, 2 * smooth.reports[0].after.bending) << rough;
    EXPECT_EQ(result.reports[0].termination, Outcome::kConverged);
    for (const VertexId v : clicks()) {
      const SurfacePoint click = SurfacePoint::at_vertex(opened->surface(), v);
      EXPECT_EQ(std::count(result.curves[0].points.begin(), result.curves[0].points.end(), click),
                1);
    }
  }
}

TEST(RoughGround, TheReportTellsTheRoughness) {
  EXPECT_LT(clicked(rough_sphere(0)).reports[0].roughness_near, 0.01);
  EXPECT_NEAR(clicked(rough_sphere(0.3)).reports[0].roughness_near, 0.3, 0.06);
}

TEST(RoughGround, TautCurvesAreGeodesicsOfTheMeshAsItIs) {
  const auto opened = rough_sphere(0.3);
  const SurfaceCurve drawn = test::vertex_curve(
      opened->surface(), draw_edge_path(opened->surface(), test::ids({0, 4})), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  SmoothingOptions options;
  options.tau = 0;
  const SmoothingResult taut = smoother.smooth(options);
  const SurfaceCurve& curve = taut.curves[0];
  for (std::size_t i = 1; i + 1 < curve.points.size(); ++i) {
    EXPECT_LT(
        turning_angle(opened->surface(), curve.points[i - 1], curve.points[i], curve.points[i + 1]),
        1e-5);
  }
  // And back: the fair result does not depend on earlier calls.
  const SmoothingResult fair = smoother.smooth(1), again = smooth_curve(opened, drawn);
  EXPECT_EQ(fair.curves[0].points, again.curves[0].points);
  // Turns are those of the ground, but ends and length those of the mesh.
  const auto tortuosity = [&](const SurfaceCurve& c) {
    return measure_curve(opened->mesh(), c, 1).tortuosity;
  };
  EXPECT_NEAR(fair.reports[0].before.tortuosity, tortuosity(drawn), 1e-12);
  EXPECT_NEAR(fair.reports[0].after.tortuosity, tortuosity(fair.curves[0]), 1e-12);
}

TEST(RoughGround, TurnsOfAStrokeWithARestAreThoseOfTheGround) {
  const auto opened = rough_sphere(0.3);
  const Surface& surface = opened->surface();
  SurfaceCurve drawn =
      test::vertex_curve(surface, draw_edge_path(surface, test::ids({0, 4})), false);
  const std::size_t middle = drawn.points.size() / 2;
  const FaceId face = common_face(surface, drawn.points[middle - 1], drawn.points[middle]);
  std::vector<SurfacePoint> rest;
  for (int k = 0; k < 60; ++k) {
    const double a = 0.33 + 0.004 * (k % 7), b = 0.33 + 0.004 * (k % 5);
    rest.push_back(SurfacePoint::in_face(surface, face, {a, b, 1 - a - b}));
  }
  drawn.points.insert(drawn.points.begin() + static_cast<std::ptrdiff_t>(middle), rest.begin(),
                      rest.end());
  const SmoothingReport report = smooth_curve(opened, drawn).reports[0];
  ASSERT_GT(report.left_out, 0U);
  const Surface& ground = opened->ground({})->surface();
  EXPECT_NEAR(report.before.bending, measure_curve(ground, drawn, report.edge_length_near).bending,
              1e-9 * report.before.bending);
  EXPECT_NEAR(report.before.length, curve_length(surface, drawn), 1e-12);
}

TEST(RoughGround, PinsHoldAndADraggedStrokeIsSmoothedAnew) {
  const auto opened = rough_sphere(0.3);
  const std::vector<VertexId> way = draw_edge_path(opened->surface(), test::ids({0, 4}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), way, false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  smoother.smooth(1);
  const SurfacePoint pin = drawn.points[drawn.points.size() / 2];
  smoother.set_pins(std::span(&pin, 1));
  const SmoothingResult pinned = smoother.smooth(1);
  EXPECT_EQ(std::count(pinned.curves[0].points.begin(), pinned.curves[0].points.end(), pin), 1);
  const SmoothingResult dragged = smoother.drag(0, drawn);
  EXPECT_EQ(dragged.curves[0].points, pinned.curves[0].points);
}

TEST(RoughGround, CancellingLeavesNothingHalf) {
  const auto opened = rough_sphere(0.3);
  const SurfaceCurve drawn = test::vertex_curve(
      opened->surface(), draw_edge_path(opened->surface(), test::ids({0, 4})), false);
  CurveSmoother smoother(opened);
  for (int asked = 0; asked < 60; asked += 7) {
    int left = asked;
    EXPECT_FALSE(smoother.set_curve(drawn, {}, [&](const char*, double) { return left-- > 0; }))
        << asked;
  }
  ASSERT_TRUE(smoother.set_curve(drawn));
  EXPECT_EQ(smoother.smooth().curves[0].points, smooth_curve(opened, drawn).curves[0].points);
}

}  // namespace
}  // namespace talweg
