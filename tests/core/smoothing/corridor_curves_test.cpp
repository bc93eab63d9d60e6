// Curves smoothed in a corridor stay inside, do not collapse, and are round.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg::corridor_curves_test {
namespace {

using test::grid;

using test::ids;

SmoothingResult in_corridor(const std::shared_ptr<const OpenedMesh>& opened,
                            const SurfaceCurve& drawn, const SmoothingOptions& options) {
  return smooth_curve(opened, drawn, options, {.method = Method::kCorridor});
}

/// A zigzag along a row of a plane grid, from left to right.
SurfaceCurve zigzag(const Surface& surface, std::uint32_t columns) {
  std::vector<VertexId> way;
  for (std::uint32_t i = 0; i <= columns; ++i)
    way.emplace_back((3 + (i / 2) % 2) * (columns + 1) + i);
  return test::vertex_curve(surface, draw_edge_path(surface, way), false);
}

TEST(CorridorCurves, LoopsOnADiscHoldAndAreRound) {
  const auto opened = OpenedMesh::open(grid(60, 60));
  for (const double radius : {5.0, 12.0, 25.0}) {
    const SurfaceCurve drawn = test::jagged_circle(opened->mesh(), 60, radius);
    for (const double tau : {0.25, 0.5, 1.0, 2.0, 4.0}) {
      const SmoothingReport report = in_corridor(opened, drawn, {.tau = tau}).report();
      EXPECT_EQ(report.termination, Outcome::kConverged) << radius << " " << tau;
      // The zigzag itself makes up a quarter of the drawn length.
      EXPECT_GE(report.after.length, 0.4 * report.before.length) << radius << " " << tau;
      EXPECT_GE(report.after.total_curvature,
                2 * std::numbers::pi * (1 - 1e-9));  // Gauss and Bonnet
      if (radius > 10 && tau >= 1) {
        EXPECT_LT(report.after.total_curvature,
                  2 * std::numbers::pi + 0.2 * report.before.total_curvature);
      }
    }
  }
}

TEST(CorridorCurves, FairingTurnsNoMoreAndKeepsTheEnds) {
  const auto opened = OpenedMesh::open(test::sphere(5));
  const auto path = draw_edge_path(opened->surface(), ids({0, 2500, 3, 800}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), path, false);
  for (const double tau : {0.5, 1.0, 2.0, 4.0}) {
    const SmoothingResult rough = in_corridor(opened, drawn, {.tau = tau, .finish = Finish::kTaut});
    const SmoothingResult fine = in_corridor(opened, drawn, {.tau = tau});
    EXPECT_LE(fine.report().after.total_curvature, rough.report().after.total_curvature + 0.2)
        << tau;
    EXPECT_LT(fine.report().after.total_curvature, 0.3 * fine.report().before.total_curvature)
        << tau;
    EXPECT_EQ(fine.curve().points.front(), drawn.points.front());
    EXPECT_EQ(fine.curve().points.back(), drawn.points.back());
    for (std::size_t i = 0; i + 1 < fine.curve().points.size(); ++i) {
      EXPECT_TRUE(common_face(opened->surface(), fine.curve().points[i], fine.curve().points[i + 1])
                      .valid());
    }
  }
}

TEST(CorridorCurves, ADrawingThatIsStraightStays) {
  const auto opened = OpenedMesh::open(grid(20, 20));
  std::vector<VertexId> row;
  for (std::uint32_t i = 2; i <= 18; ++i) row.emplace_back(10 * 21 + i);
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), row, false);
  const SmoothingReport report = in_corridor(opened, drawn, {.tau = 2}).report();
  EXPECT_NEAR(report.after.length, 16, 1e-12);
  EXPECT_LT(report.deviation_to_drawn_max, 1e-8);
}

TEST(CorridorCurves, ScalesWithTheMesh) {
  MeshLists lists = grid(40, 40);
  for (Point& p : lists.points) {  // no ties
    p += 0.2 * Point(std::sin(3 * p.y()), std::cos(5 * p.x() + p.y()), std::sin(p.x()));
  }
  MeshLists large = lists;
  for (Point& p : large.points) p *= 1e6;
  const auto small_mesh = OpenedMesh::open(lists), large_mesh = OpenedMesh::open(large);
  const SurfaceCurve drawn = test::jagged_circle(small_mesh->mesh(), 40, 12);
  const SmoothingReport a = in_corridor(small_mesh, drawn, {.tau = 1}).report();
  const SmoothingReport b = in_corridor(large_mesh, drawn, {.tau = 1}).report();
  EXPECT_NEAR(b.after.length / a.after.length, 1e6, 1);
  EXPECT_NEAR(b.after.total_curvature, a.after.total_curvature, 1e-3);
  EXPECT_NEAR(b.slack / a.slack, 1e6, 1e-3);
}

// Walls are never nearer than 1.5 eighths of an edge at tau = 1.
TEST(CorridorCurves, AFieldThatIsZeroOnOneHalfHoldsThatHalf) {
  const auto opened = OpenedMesh::open(grid(40, 7));
  const SurfaceMesh& mesh = opened->mesh();
  const SurfaceCurve drawn = zigzag(mesh.surface(), 40);
  PolylineDistance distance(mesh.surface());
  distance.set(std::span(&drawn, 1));
  SmoothingOptions options;
  options.slack_at.emplace_back();
  for (const Point& p : positions_of(mesh, drawn)) {
    options.slack_at[0].push_back(p.x() <= 20 ? 0 : 2);
  }
  const SmoothingResult result = in_corridor(opened, drawn, options);
  double left = 0, right = 0;
  for (const SurfacePoint& p : result.curve().points) {
    const double deviation = distance.at(p).distance;
    double& side = mesh.position(p).x() <= 19 ? left : right;
    side = std::max(side, deviation);
  }
  EXPECT_LE(left, 1.5 / 8 * result.report().edge_length_near);
  EXPECT_GT(right, 0.3);
}

}  // namespace
}  // namespace talweg::corridor_curves_test
