// Drawn loops do not collapse in the corridor, on any surface.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/reference_data.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;

constexpr double kTaus[] = {0.25, 0.5, 1, 4};

/// `smooth_length`: the length of the loop without its zigzag.
void expect_held(const SmoothingReport& report, double smooth_length) {
  EXPECT_EQ(report.termination, Outcome::kConverged);
  EXPECT_GE(report.after.length, smooth_length / 2);
  // A loop gets shorter by rounder ends, which matters for a loop of width one edge.
  EXPECT_LE(report.after.length, 1.1 * report.before.length);
  EXPECT_TRUE(std::isfinite(report.after.total_curvature));
  EXPECT_TRUE(std::isfinite(report.deviation_to_drawn_max));
  EXPECT_TRUE(std::isfinite(report.deviation_from_drawn_max));
  EXPECT_GT(report.slack, 0);
}

void expect_holds(const std::shared_ptr<const OpenedMesh>& opened, const SurfaceCurve& drawn,
                  double smooth_length) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : kTaus) {
    SCOPED_TRACE(testing::Message() << "tau " << tau);
    const SmoothingResult result = smoother.smooth(tau);
    expect_held(result.report(), smooth_length);
    for (const SurfacePoint& p : result.curve().points) {
      ASSERT_TRUE(opened->mesh().position(p).allFinite());
    }
    EXPECT_TRUE(self_contacts(opened->surface(), result.curves).empty());
  }
}

/// A loop of vertices (column, row) of a grid of this many columns.
SurfaceCurve on_grid(const Surface& surface, std::uint32_t columns,
                     const std::vector<std::pair<std::uint32_t, std::uint32_t>>& way) {
  std::vector<VertexId> vertices;
  vertices.reserve(way.size());
  for (const auto& [i, j] : way) vertices.emplace_back(j * (columns + 1) + i);
  return test::vertex_curve(surface, draw_edge_path(surface, vertices, true), true);
}

/// During fairing, a set with a thin loop calls the progress callback at most half as often again
/// as its curves alone. The number of calls measures the work.
TEST(CorridorLoops, AThinLoopHoldsAndDoesNotSlowOtherCurves) {
  constexpr std::uint32_t kAcross = 60;
  const auto opened = OpenedMesh::open(grid(kAcross, kAcross));
  std::vector<SurfaceCurve> lines;
  for (std::uint32_t y = 20; y < kAcross; y += 8) {
    std::vector<VertexId> zigzag;
    for (std::uint32_t x = 1; x < kAcross; x += 2) {
      zigzag.emplace_back((y + x / 2 % 2) * (kAcross + 1) + x);
    }
    lines.push_back(test::vertex_curve(opened->surface(),
                                       draw_edge_path(opened->surface(), zigzag, false), false));
  }
  const SurfaceCurve thin =
      on_grid(opened->surface(), kAcross, {{4, 10}, {20, 10}, {20, 11}, {4, 11}});
  struct Fair {
    SmoothingResult result;
    std::size_t asked = 0;
  };
  const auto fair = [&](const std::vector<SurfaceCurve>& curves) {
    Fair made;
    const Progress progress = [&](const char* stage, double) {
      made.asked += std::string_view(stage) == "fair" ? 1U : 0U;
      return true;
    };
    CurveSmoother smoother(opened);
    smoother.set_curves(curves, {}, progress);
    made.result = smoother.smooth(SmoothingOptions{.tau = 0.25}, progress);
    return made;
  };
  const Fair without = fair(lines), alone = fair({thin});
  std::vector<SurfaceCurve> all = lines;
  all.push_back(thin);
  const Fair set = fair(all);
  expect_held(set.result.reports.back(), curve_length(opened->surface(), thin));
  for (std::size_t c = 0; c < lines.size(); ++c) {
    EXPECT_EQ(set.result.curves[c].points, without.result.curves[c].points) << c;
  }
  EXPECT_LT(set.asked, without.asked + alone.asked + without.asked / 2);
}

TEST(CorridorLoops, ThatAreThinOrSmallPassTheirPins) {
  constexpr std::uint32_t kAcross = 24;
  using Way = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  const auto opened = OpenedMesh::open(grid(kAcross, kAcross));
  for (const Way& way :
       {Way{{4, 10}, {20, 10}, {20, 11}, {4, 11}}, Way{{10, 10}, {12, 10}, {12, 12}},
        Way{{10, 10}, {11, 11}, {12, 12}, {12, 11}, {11, 10}},
        Way{{10, 10}, {11, 11}, {11, 12}, {10, 11}}, Way{{4, 4}, {20, 20}, {20, 19}, {5, 4}}}) {
    const SurfaceCurve drawn = on_grid(opened->surface(), kAcross, way);
    CurveSmoother smoother(opened);
    smoother.set_curve(drawn, {.pins = {drawn.points.front()}});
    for (const double tau : kTaus) {
      const std::vector<SurfacePoint> points = smoother.smooth(tau).curve().points;
      EXPECT_NE(std::find(points.begin(), points.end(), drawn.points.front()), points.end())
          << tau << ", " << way.size();
    }
  }
}

TEST(CorridorLoops, OnAPlaneFromTwelveEdgesUpToTheSizeOfTheMesh) {
  const auto opened = OpenedMesh::open(grid(60, 60));
  for (const double radius : {2.0, 3.0, 5.0, 9.0, 16.0, 29.0}) {
    SCOPED_TRACE(testing::Message() << "radius " << radius);
    const auto points = test::circle({30, 30, 0}, {radius, 0, 0}, {0, radius, 0}, 16);
    const SurfaceCurve drawn = test::drawn_near(opened->mesh(), points, true);
    EXPECT_GE(drawn.points.size(), 12U);
    expect_holds(opened, drawn, 2 * std::numbers::pi * radius);
  }
}

TEST(CorridorLoops, OnHills) {
  const auto opened = OpenedMesh::open(test::hills(40));
  for (const double radius : {2.0, 4.0, 8.0, 16.0}) {
    SCOPED_TRACE(testing::Message() << "radius " << radius);
    const auto points = test::circle({20, 20, 0}, {radius, 0, 0}, {0, radius, 0}, 12);
    const SurfaceCurve drawn = test::drawn_near(opened->mesh(), points, true);
    // The way over the hills is not shorter than the way below them.
    expect_holds(opened, drawn, 2 * std::numbers::pi * radius * 0.9);
  }
}

TEST(CorridorLoops, OnASphereUpToTheEquator) {
  const auto opened = OpenedMesh::open(test::sphere(5));
  for (const double angle : {0.12, 0.3, 0.7, 1.2, 1.5}) {
    SCOPED_TRACE(testing::Message() << "angle " << angle);
    const Point axis = Point(1, 2, 3).normalized(), right = Point(2, -1, 0).normalized();
    const double radius = std::sin(angle);
    const auto points =
        test::circle(std::cos(angle) * axis, radius * right, radius * axis.cross(right), 16);
    expect_holds(opened, test::drawn_near(opened->mesh(), points, true),
                 2 * std::numbers::pi * radius);
  }
}

TEST(CorridorLoops, AroundATube) {
  const std::uint32_t columns = 40, rows = 30;
  const auto opened = OpenedMesh::open(test::tube(columns, rows, 4));
  std::vector<VertexId> way;
  for (std::uint32_t i = 0; i < columns; i += 2) {
    way.emplace_back((14 + i / 2 % 3) * columns + i);
  }
  const SurfaceCurve drawn =
      test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), way, true), true);
  const double around = 2 * columns * std::sin(std::numbers::pi / columns);
  expect_holds(opened, drawn, around);
  // A loop around the tube is not shorter than the tube's circumference.
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  EXPECT_GE(smoother.smooth(1).report().after.length, around * (1 - 1e-9));
}

TEST(CorridorLoops, AroundAHandle) {
  const std::uint32_t columns = 24, rows = 72;
  const auto opened = OpenedMesh::open(test::torus(columns, rows));
  std::vector<VertexId> small, large;
  for (std::uint32_t i = 0; i < columns; i += 2) {
    small.emplace_back((10 + i / 2 % 3) * columns + i);
  }
  for (std::uint32_t j = 0; j < rows; j += 2) large.emplace_back(j * columns + j / 2 % 3);
  const Surface& surface = opened->surface();
  expect_holds(opened, test::vertex_curve(surface, draw_edge_path(surface, small, true), true),
               2 * std::numbers::pi);
  expect_holds(opened, test::vertex_curve(surface, draw_edge_path(surface, large, true), true),
               2 * std::numbers::pi * 4);
}

// A limb: a cone with its apex. A loop around the cone could slip off; a short loop lies near the
// apex.
TEST(CorridorLoops, AroundALimb) {
  const std::uint32_t columns = 32, rows = 40;
  MeshLists limb = test::tube(columns, rows, 6);
  for (Point& p : limb.points) {
    const double narrow = 1.05 - p.z() / 6;
    p.x() *= narrow;
    p.y() *= narrow;
  }
  const auto apex = static_cast<std::uint32_t>(limb.points.size());
  limb.points.emplace_back(0, 0, 6.3);
  for (std::uint32_t i = 0; i < columns; ++i) {
    const std::uint32_t top = (rows - 1) * columns;
    limb.triangles.push_back({top + i, top + (i + 1) % columns, apex});
  }
  const auto opened = OpenedMesh::open(limb);
  for (const std::uint32_t row : {10U, 22U, 32U}) {
    SCOPED_TRACE(testing::Message() << "row " << row);
    std::vector<VertexId> way;
    for (std::uint32_t i = 0; i < columns; i += 2) {
      way.emplace_back((row + i / 2 % 2) * columns + i);
    }
    const SurfaceCurve drawn =
        test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), way, true), true);
    const double radius = 1.05 - (row + 1.0) / (rows - 1);
    expect_holds(opened, drawn, 2 * std::numbers::pi * radius);
  }
}

TEST(CorridorLoops, AlongTheBoundary) {
  const std::uint32_t n = 30;
  const auto opened = OpenedMesh::open(grid(n, n));
  for (const std::uint32_t inside : {0U, 1U}) {
    SCOPED_TRACE(testing::Message() << inside << " edges inside");
    const std::uint32_t last = n - inside;
    const SurfaceCurve drawn = on_grid(
        opened->surface(), n, {{inside, inside}, {last, inside}, {last, last}, {inside, last}});
    expect_holds(opened, drawn, 4.0 * (n - 2 * inside));
  }
}

// No vertex of the mesh lies inside these loops.
TEST(CorridorLoops, ThinOnesOfOneEdge) {
  const auto opened = OpenedMesh::open(grid(40, 20));
  const auto rough = OpenedMesh::open(test::hills(40));
  for (const std::uint32_t columns : {5U, 10U, 20U}) {
    SCOPED_TRACE(testing::Message() << columns << " columns");
    const std::uint32_t last = 10 + columns;
    const double around = 2.0 * (columns + 1);
    expect_holds(opened, on_grid(opened->surface(), 40, {{10, 9}, {last, 9}, {last, 10}, {10, 10}}),
                 around);
    expect_holds(rough, on_grid(rough->surface(), 40, {{10, 9}, {last, 9}, {last, 10}, {10, 10}}),
                 around);
  }
}

TEST(CorridorLoops, ThinOnesOfTwentyByTwoEdges) {
  const auto opened = OpenedMesh::open(grid(40, 20));
  expect_holds(opened, on_grid(opened->surface(), 40, {{10, 9}, {30, 9}, {30, 11}, {10, 11}}), 44);
  const auto rough = OpenedMesh::open(test::hills(40));
  expect_holds(rough, on_grid(rough->surface(), 40, {{10, 19}, {30, 19}, {30, 21}, {10, 21}}), 44);
}

/// Whether a point of the plane z = 0 is inside a polygon.
bool is_inside(const std::vector<Point>& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

class TwoLoops : public testing::Test {
 protected:
  [[nodiscard]] SurfaceCurve around(double x, double radius) const {
    const auto points = test::circle({x, 30, 0}, {radius, 0, 0}, {0, radius, 0}, 16);
    return test::drawn_near(opened->mesh(), points, true);
  }
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(grid(60, 60));
};

TEST_F(TwoLoops, BesideEachOtherHoldAndStayApart) {
  CurveSmoother smoother(opened);
  smoother.set_curves(std::vector{around(18, 10), around(41, 10)});  // from 28 to 31
  for (const double tau : kTaus) {
    SCOPED_TRACE(testing::Message() << "tau " << tau);
    const SmoothingResult result = smoother.smooth(tau);
    for (const SmoothingReport& report : result.reports) {
      expect_held(report, 2 * std::numbers::pi * 10);
    }
    EXPECT_TRUE(crossing_curves(opened->surface(), result.curves).empty());
    EXPECT_TRUE(self_contacts(opened->surface(), result.curves).empty());
  }
}

// Three edges apart all around.
TEST_F(TwoLoops, WithinEachOtherHoldAndDoNotCross) {
  CurveSmoother smoother(opened);
  smoother.set_curves(std::vector{around(30, 12), around(30, 15)});
  for (const double tau : kTaus) {
    SCOPED_TRACE(testing::Message() << "tau " << tau);
    const SmoothingResult result = smoother.smooth(tau);
    expect_held(result.reports[0], 2 * std::numbers::pi * 12);
    expect_held(result.reports[1], 2 * std::numbers::pi * 15);
    EXPECT_TRUE(crossing_curves(opened->surface(), result.curves).empty());
    const std::vector<Point> outer = positions_of(opened->mesh(), result.curves[1]);
    for (const Point& p : positions_of(opened->mesh(), result.curves[0])) {
      EXPECT_TRUE(is_inside(outer, p)) << p.transpose();
    }
  }
}

TEST(CorridorLoops, OnTheArmadillo) {
  for (const char* name : {"armadillo_86k_loop_small", "armadillo_86k_loop_large"}) {
    SCOPED_TRACE(name);
    const auto mesh_file = test::mesh_folder() / "armadillo_86k.ply";
    std::ifstream numbers(test::reference_folder() / "curves" / (std::string(name) + ".txt"));
    if (!numbers || !std::filesystem::exists(mesh_file)) GTEST_SKIP() << test::missing(name);
    const auto opened = OpenedMesh::open(test::read_reference_mesh(mesh_file));
    std::vector<VertexId> path;
    for (std::size_t v = 0; numbers >> v;) path.emplace_back(v);
    const SurfaceCurve drawn = curve_through(opened->surface(), path);
    ASSERT_TRUE(drawn.closed);
    // An edge path is longer than a straight one by a sixth at most on equilateral triangles.
    const double length = curve_length(opened->surface(), drawn);
    expect_holds(opened, drawn, length * std::sqrt(3) / 2);
  }
}

}  // namespace
}  // namespace talweg
