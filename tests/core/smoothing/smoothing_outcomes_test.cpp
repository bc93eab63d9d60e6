// Reports of special outcomes: cancelled, needles, blocked, bumps.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;

bool has_warning(const SmoothingReport& report, const char* words) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

TEST(SmoothingOutcomes, ACancelledCallGivesTheDrawingBack) {
  const auto opened = OpenedMesh::open(grid(10, 10));
  const SurfaceCurve drawn = curve_through(opened->surface(), ids({24, 25, 37, 38, 50, 51}));
  SmoothingOptions options;
  const Progress progress = [](const char*, double) { return false; };
  const SmoothingResult result =
      smooth_curve(opened, drawn, options, {.method = Method::kPaper}, progress);
  EXPECT_EQ(result.report().termination, Outcome::kCancelled);
  EXPECT_EQ(result.curve().points, drawn.points);
}

TEST(SmoothingOutcomes, AListThatEndsWithItsFirstVertexIsClosed) {
  const auto opened = OpenedMesh::open(grid(4, 4));
  const SurfaceCurve open = curve_through(opened->surface(), ids({6, 7, 12}));
  EXPECT_FALSE(open.closed);
  EXPECT_EQ(open.points.size(), 3U);
  const SurfaceCurve closed = curve_through(opened->surface(), ids({6, 7, 12, 6}));
  EXPECT_TRUE(closed.closed);
  EXPECT_EQ(closed.points, open.points);
  EXPECT_THROW(curve_through(opened->surface(), ids({6, 18})), Error);
  EXPECT_THROW(curve_through(opened->surface(), {}), Error);
}

TEST(SmoothingOutcomes, NeedlesAreToldAndHarmless) {
  MeshLists lists = grid(12, 12);
  lists.points[5 * 13 + 5] = lists.points[5 * 13 + 6] - Point(1e-9, 0, 0);
  const auto opened = OpenedMesh::open(lists);
  std::vector<VertexId> row;
  for (std::uint32_t i = 1; i < 12; ++i) row.emplace_back((6 + i % 2) * 13 + i);
  const SurfaceCurve drawn =
      test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), row, false), false);
  const SmoothingResult result = smooth_curve(opened, drawn, {}, {.method = Method::kPaper});
  EXPECT_TRUE(has_warning(result.report(), "needle triangles"));
  // The needle needs hardly any mollification: at most 1e-5 mean edges are added
  // (mollification.hpp).
  EXPECT_GT(result.report().mollification, 0);
  EXPECT_LE(result.report().mollification, 1e-5 * opened->mesh().mean_edge_length());
  EXPECT_EQ(smooth_curve(opened, drawn).report().mollification,
            0);  // the corridor needs no mollification
  EXPECT_LT(result.report().after.length, result.report().before.length);
}

TEST(SmoothingOutcomes, PathsBecomeStraightOverPleatsWithoutWidth) {
  // Every third column of a sheet is folded back and forth by w: three layers. For w = 0 these have
  // faces without area and edges without length.
  for (const double w : {1e-3, 1e-12, 0.0}) {
    const std::uint32_t columns = 18, rows = 6;
    MeshLists lists = grid(columns, rows);
    std::vector<double> folded(columns + 1, 0);
    for (std::uint32_t i = 1; i <= columns; ++i) {
      folded[i] = folded[i - 1] + (i % 3 == 0 ? -w : i % 3 == 1 ? 1 : w);
    }
    for (std::size_t v = 0; v < lists.points.size(); ++v) {
      lists.points[v].x() = folded[v % (columns + 1)];
    }
    const auto opened = OpenedMesh::open(lists);
    std::vector<VertexId> stairs;
    for (std::uint32_t i = 0; i <= columns; ++i) stairs.emplace_back(i);
    for (std::uint32_t j = 1; j <= rows; ++j) stairs.emplace_back(j * (columns + 1) + columns);
    const SurfaceCurve drawn = test::vertex_curve(opened->surface(), stairs, false);
    for (const Method method : {Method::kPaper, Method::kCorridor}) {
      const SmoothingReport report =
          smooth_curve(opened, drawn, {.tau = 0}, {.method = method}).report();
      EXPECT_NEAR(report.after.length, std::hypot(6 + 12 * w, 6.0), 1e-9) << w;
    }
  }
}

// Found by random runs: a scan far from the origin with coordinates rounded together.
TEST(SmoothingOutcomes, ACurveOverFacesWithoutExtentIsRefusedWithItsPlace) {
  MeshLists lists = grid(6, 6);
  for (std::size_t v = 0; v < 21; ++v) lists.points[v] = Point(2, 0.5, 1);
  const auto opened = OpenedMesh::open(lists);
  const SurfaceCurve drawn = curve_through(opened->surface(), ids({1, 2, 3, 10, 9}));
  for (const Method method : {Method::kCorridor, Method::kPaper}) {
    try {
      CurveSmoother smoother(opened);
      smoother.set_curve(drawn, {.method = method});
      FAIL() << "was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
      EXPECT_NE(std::string(error.what()).find("(2, 0.5, 1)"), std::string::npos) << error.what();
    }
  }
}

TEST(SmoothingOutcomes, AJointThatAnotherCurveHoldsIsTold) {
  // The second curve ends inside the bend of the first, which cannot pass it.
  const auto opened = OpenedMesh::open(grid(10, 10));
  const auto at = [](std::uint32_t i, std::uint32_t j) { return VertexId{j * 11 + i}; };
  const std::vector<SurfaceCurve> drawn = {
      test::vertex_curve(
          opened->surface(),
          draw_edge_path(opened->surface(), std::vector{at(1, 5), at(5, 9), at(9, 5)}, false),
          false),
      test::vertex_curve(opened->surface(),
                         draw_edge_path(opened->surface(), std::vector{at(5, 1), at(5, 7)}, false),
                         false)};
  CurveSmoother smoother(opened);
  smoother.set_curves(drawn, {.method = Method::kPaper});
  SmoothingOptions straight;
  straight.tau = 0;
  const SmoothingResult result = smoother.smooth(straight);
  EXPECT_TRUE(has_warning(result.reports[0], "another part of the drawing is in the way"));
  // The shortest way above the obstacle's end.
  EXPECT_NEAR(result.reports[0].after.length, 2 * std::hypot(4, 2), 1e-9);
  EXPECT_NEAR(result.reports[1].after.length, 6, 1e-12);
}

TEST(SmoothingOutcomes, ABumpOverAConstantSlopeChangesNothingButTheValley) {
  // Equation 3 averages symmetrically. Away from the drawing and the boundary, where the distance
  // is linear, the distance is unchanged; at the drawing, where it is convex, it rises.
  const auto opened = OpenedMesh::open(grid(40, 40));
  std::vector<VertexId> row;
  for (std::uint32_t i = 0; i <= 40; ++i) row.emplace_back(20 * 41 + i);
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), row, false);
  CurveSmoother plain(opened), smoothed(opened);
  plain.set_curve(drawn, {.method = Method::kPaper});
  smoothed.set_curve(drawn, {.method = Method::kPaper, .bump_radius = 2});
  for (const std::uint32_t j : {25U, 28U, 15U}) {
    const std::size_t v = j * 41 + 20;
    EXPECT_NEAR(smoothed.distance()[v], plain.distance()[v], 0.02) << j;
  }
  EXPECT_GT(smoothed.distance()[20 * 41 + 20], plain.distance()[20 * 41 + 20] + 0.2);
  EXPECT_EQ(smoothed.smooth(1.0).report().termination, Outcome::kConverged);
}

}  // namespace
}  // namespace talweg
