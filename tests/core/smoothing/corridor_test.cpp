#include "talweg/core/smoothing/corridor.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;

SurfaceCurve jagged_circle(const SurfaceMesh& mesh, std::uint32_t columns, double radius) {
  std::vector<VertexId> way;
  const double centre = columns / 2.0;
  for (int k = 0; k < 8; ++k) {
    const double angle = std::numbers::pi * k / 4;
    const auto x = static_cast<std::uint32_t>(std::lround(centre + radius * std::cos(angle)));
    const auto y = static_cast<std::uint32_t>(std::lround(centre + radius * std::sin(angle)));
    way.emplace_back(y * (columns + 1) + x);
  }
  return test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), way, true), true);
}

SmoothingResult in_corridor(const std::shared_ptr<const OpenedMesh>& opened,
                            const SurfaceCurve& drawn, const SmoothingOptions& options) {
  return smooth_curve(opened, drawn, options, {.method = Method::kCorridor});
}

TEST(Corridor, IsFlatWithinTheSlackAndAParabolaBeyond) {
  const auto opened = OpenedMesh::open(grid(20, 20));
  const Surface& surface = opened->surface();
  std::vector<VertexId> row;
  for (std::uint32_t i = 0; i <= 20; ++i) row.emplace_back(10 * 21 + i);
  const SurfaceCurve drawn = test::vertex_curve(surface, row, false);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  const Corridor corridor(distance, 0.5, {{.slack = 1.5, .length = 4}});
  for (std::uint32_t j = 0; j <= 20; ++j) {
    const double d = std::abs(static_cast<double>(j) - 10);
    const double expected = d > 1.5 ? 4 * std::pow(10 * 0.5 * (d - 1.5) / 4, 2) : 0;
    EXPECT_NEAR(corridor.at_vertex(VertexId{j * 21 + 7})[0], expected, 1e-10);
  }
}

TEST(Corridor, AConstantFieldIsTheNumber) {
  const auto opened = OpenedMesh::open(grid(30, 30));
  const Surface& surface = opened->surface();
  const SurfaceCurve drawn = jagged_circle(opened->mesh(), 30, 8);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  const Corridor number(distance, 1, {{.closed = true, .slack = 0.3, .length = 8}});
  const Corridor field(
      distance, 1,
      {{.closed = true, .length = 8, .slack_at = std::vector<double>(drawn.points.size(), 0.3)}});
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    EXPECT_EQ(number.at_vertex(VertexId{v}), field.at_vertex(VertexId{v}));
  }
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const SurfacePoint p = SurfacePoint::on_edge(surface, EdgeId{e}, 0.3);
    EXPECT_EQ(number.at(p), field.at(p));
  }
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const SurfacePoint p = SurfacePoint::in_face(surface, FaceId{f}, {0.2, 0.3, 0.5});
    EXPECT_EQ(number.at(p), field.at(p));
  }
}

// A row of a plane grid with a slack that grows by 0.1 per unit: all in closed form.
TEST(Corridor, AFieldIsLinearBetweenThePointsOfTheDrawing) {
  const auto opened = OpenedMesh::open(grid(20, 20));
  const Surface& surface = opened->surface();
  std::vector<VertexId> row;
  for (std::uint32_t i = 0; i <= 20; ++i) row.emplace_back(10 * 21 + i);
  const SurfaceCurve drawn = test::vertex_curve(surface, row, false);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  Corridor::Valley valley{.length = 4};
  for (int i = 0; i <= 20; ++i) valley.slack_at.push_back(0.1 * i);
  const Corridor corridor(distance, 0.5, {valley});
  const double steepness = std::pow(10 * 0.5, 2) / 4;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const Point &p = opened->mesh().point(surface.tail(h)),
                &q = opened->mesh().point(surface.head(h));
    if (p.y() < 10 || q.y() < 10) continue;
    const double t = 0.3;
    const Point x = p + t * (q - p);
    const double beyond = (x.y() - 10) - 0.1 * x.x();
    const auto value = corridor.at(SurfacePoint::on_edge(surface, EdgeId{e}, t));
    if (std::abs(beyond) < 1e-9) continue;  // on the border
    const bool outside = beyond > 0;
    EXPECT_NEAR(value[0], outside ? steepness * beyond * beyond : 0, 1e-9);
  }
}

TEST(Corridor, AFieldGoesOnAcrossTheEndOfALoop) {
  const auto opened = OpenedMesh::open(grid(12, 12));
  const Surface& surface = opened->surface();
  // The square (4, 4), (8, 4), (8, 8), (4, 8); the last segment leads from (4, 8) back.
  const SurfaceCurve drawn = test::vertex_curve(
      surface, draw_edge_path(surface, ids({4 * 13 + 4, 4 * 13 + 8, 8 * 13 + 8, 8 * 13 + 4}), true),
      true);
  ASSERT_EQ(drawn.points.size(), 16U);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  Corridor::Valley valley{.closed = true, .length = 10, .turns = 0};
  valley.slack_at.assign(16, 0.5);
  valley.slack_at[15] = 1;  // at (4, 5); 0.5 at (4, 4)
  const Corridor corridor(distance, 1, {valley});
  // Left of the closing segment: the edge from (2, 4) to (2, 5).
  const HalfedgeId h = surface.find_halfedge(VertexId{4 * 13 + 2}, VertexId{5 * 13 + 2});
  const bool upwards = h == halfedge_of(edge_of(h));
  const auto value = corridor.at(SurfacePoint::on_edge(surface, edge_of(h), upwards ? 0.25 : 0.75));
  const double beyond = 2 - (0.5 + 0.25 * 0.5);
  EXPECT_NEAR(value[0], 10 * beyond * beyond, 1e-9);
}

/// A zigzag along a row of a plane grid, from left to right.
SurfaceCurve zigzag(const Surface& surface, std::uint32_t columns) {
  std::vector<VertexId> way;
  for (std::uint32_t i = 0; i <= columns; ++i)
    way.emplace_back((3 + (i / 2) % 2) * (columns + 1) + i);
  return test::vertex_curve(surface, draw_edge_path(surface, way), false);
}

// Walls are never nearer than 1.5 eighths of an edge at tau = 1.
TEST(Corridor, AFieldThatIsZeroOnOneHalfHoldsThatHalf) {
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

TEST(Corridor, RefusesAFieldThatDoesNotFit) {
  const auto opened = OpenedMesh::open(grid(8, 8));
  const Surface& surface = opened->surface();
  const SurfaceCurve curves[] = {test::vertex_curve(surface, ids({10, 11, 12}), false),
                                 test::vertex_curve(surface, ids({46, 47}), false)};
  PolylineDistance distance(surface);
  distance.set(curves);
  const auto message = [&](const std::vector<std::vector<double>>& slack_at) -> std::string {
    try {
      const Corridor corridor(distance, 1, {{.slack_at = slack_at[0]}, {.slack_at = slack_at[1]}});
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({{0, 1, 0}, {2, 2}}), "");
  EXPECT_EQ(message({{0, 1, 0}, {2}}), "slack_at has 1 values for the 2 points of curve 1.");
  for (const double bad : {-1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(message({{0, 1, 0}, {2, bad}}),
              "The slack of curve 1 at its point 1 must be finite and >= 0.");
  }
}

TEST(Corridor, LoopsOnADiscHoldAndAreRound) {
  const auto opened = OpenedMesh::open(grid(60, 60));
  for (const double radius : {5.0, 12.0, 25.0}) {
    const SurfaceCurve drawn = jagged_circle(opened->mesh(), 60, radius);
    for (const double tau : {0.25, 0.5, 1.0, 2.0, 4.0}) {
      const SmoothingReport report = in_corridor(opened, drawn, {.tau = tau}).report();
      EXPECT_EQ(report.termination, Outcome::kConverged) << radius << " " << tau;
      // The zigzag itself makes up a quarter of the drawn length.
      EXPECT_GE(report.length_after, 0.4 * report.length_before) << radius << " " << tau;
      EXPECT_GE(report.curvature_after, 2 * std::numbers::pi * (1 - 1e-9));  // Gauss and Bonnet
      if (radius > 10 && tau >= 1) {
        EXPECT_LT(report.curvature_after, 2 * std::numbers::pi + 0.2 * report.curvature_before);
      }
    }
  }
}

TEST(Corridor, FairingTurnsNoMoreAndKeepsTheEnds) {
  const auto opened = OpenedMesh::open(test::sphere(5));
  const auto path = draw_edge_path(opened->surface(), ids({0, 2500, 3, 800}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), path, false);
  for (const double tau : {0.5, 1.0, 2.0, 4.0}) {
    const SmoothingResult rough = in_corridor(opened, drawn, {.tau = tau, .finish = Finish::kTaut});
    const SmoothingResult fine = in_corridor(opened, drawn, {.tau = tau});
    EXPECT_LE(fine.report().curvature_after, rough.report().curvature_after + 0.2) << tau;
    EXPECT_LT(fine.report().curvature_after, 0.3 * fine.report().curvature_before) << tau;
    EXPECT_EQ(fine.curve().points.front(), drawn.points.front());
    EXPECT_EQ(fine.curve().points.back(), drawn.points.back());
    for (std::size_t i = 0; i + 1 < fine.curve().points.size(); ++i) {
      EXPECT_TRUE(common_face(opened->surface(), fine.curve().points[i], fine.curve().points[i + 1])
                      .valid());
    }
  }
}

TEST(Corridor, ADrawingThatIsStraightStays) {
  const auto opened = OpenedMesh::open(grid(20, 20));
  std::vector<VertexId> row;
  for (std::uint32_t i = 2; i <= 18; ++i) row.emplace_back(10 * 21 + i);
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), row, false);
  const SmoothingReport report = in_corridor(opened, drawn, {.tau = 2}).report();
  EXPECT_NEAR(report.length_after, 16, 1e-12);
  EXPECT_LT(report.deviation_to_drawn_max, 1e-9);
}

TEST(Corridor, ScalesWithTheMesh) {
  MeshLists lists = grid(40, 40);
  for (Point& p : lists.points) {  // no ties
    p += 0.2 * Point(std::sin(3 * p.y()), std::cos(5 * p.x() + p.y()), std::sin(p.x()));
  }
  MeshLists large = lists;
  for (Point& p : large.points) p *= 1e6;
  const auto small_mesh = OpenedMesh::open(lists), large_mesh = OpenedMesh::open(large);
  const SurfaceCurve drawn = jagged_circle(small_mesh->mesh(), 40, 12);
  const SmoothingReport a = in_corridor(small_mesh, drawn, {.tau = 1}).report();
  const SmoothingReport b = in_corridor(large_mesh, drawn, {.tau = 1}).report();
  EXPECT_NEAR(b.length_after / a.length_after, 1e6, 1);
  EXPECT_NEAR(b.curvature_after, a.curvature_after, 1e-3);
  EXPECT_NEAR(b.slack / a.slack, 1e6, 1e-3);
}

TEST(Crossings, AreFoundAndTouchingIsNone) {
  const auto opened = OpenedMesh::open(grid(4, 4));
  const Surface& surface = opened->surface();
  const auto at = [&](std::uint32_t face, double a, double b) {
    return SurfacePoint::in_face(surface, FaceId{face}, {a, b, 1 - a - b});
  };
  const std::vector<SurfaceCurve> crossing = {{false, {at(3, 0.1, 0.2), at(3, 0.7, 0.2)}},
                                              {false, {at(3, 0.4, 0.1), at(3, 0.3, 0.6)}},
                                              {false, {at(5, 0.4, 0.1), at(5, 0.3, 0.6)}}};
  EXPECT_EQ(crossing_curves(surface, crossing), (std::vector<std::size_t>{0, 1}));
  const SurfacePoint shared = at(3, 0.3, 0.3);
  const std::vector<SurfaceCurve> touching = {{false, {at(3, 0.1, 0.2), shared, at(3, 0.2, 0.1)}},
                                              {false, {at(3, 0.6, 0.3), shared}}};
  EXPECT_TRUE(crossing_curves(surface, touching).empty());
}

}  // namespace
}  // namespace talweg
