#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using namespace test;

void expect_joined(const Surface& surface, const SurfaceCurve& curve) {
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < curve.points.size(); ++i) {
    EXPECT_TRUE(
        common_face(surface, curve.points[i], curve.points[(i + 1) % curve.points.size()]).valid())
        << i;
  }
}

TEST(StraightLines, PointsAsNearToEdgesAndVerticesAsRounding) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(6, 6));
  const Surface& surface = mesh.surface();
  StraightLines lines(surface);
  for (const double e : {1e-11, 1e-13, 1e-16}) {
    // A point in each face of the sheet, near each corner and each side, so lines leave faces in
    // every way.
    std::vector<SurfacePoint> points;
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
      const FaceId face{(f * 29) % surface.face_count()};
      points.push_back(SurfacePoint::in_face(surface, face, {1 - 2 * e, e, e}));
      points.push_back(SurfacePoint::in_face(surface, face, {e, 0.5, 0.5 - e}));
      points.push_back(SurfacePoint::in_face(surface, face, {0.5, e, 0.5 - e}));
    }
    expect_joined(surface, lines.join(points, true));
  }
}

TEST(StraightLines, GapsAreCountedAndMeasured) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(10, 10));
  const auto at = [&](std::size_t x, std::size_t y) {
    return SurfacePoint::at_vertex(mesh.surface(), VertexId{y * 11 + x});
  };
  StraightLines lines(mesh.surface());
  const std::vector<SurfacePoint> points = {at(1, 1), at(2, 1), at(3, 1), at(3, 2),
                                            at(7, 5), at(8, 5), at(8, 6)};
  lines.join(points, false);
  EXPECT_EQ(lines.gaps().count, 1U);
  EXPECT_NEAR(lines.gaps().longest, 5, 1e-12);
  EXPECT_NE(gap_warning(lines.gaps()).find("1 gap of"), std::string::npos);
  EXPECT_NE(gap_warning(lines.gaps()).find("over 5 mesh units"), std::string::npos);
  lines.join(points, true);  // also the closing segment
  EXPECT_EQ(lines.gaps().count, 2U);
  lines.join(std::span(points).first(2), false);
  EXPECT_EQ(lines.gaps().count, 0U);
  EXPECT_EQ(gap_warning(lines.gaps()), "");
}

TEST(StraightLines, PointsOfDifferentComponentsAreRefused) {
  MeshLists two = grid(1, 1);
  two.triangles.push_back({4, 5, 6});
  for (int k = 0; k < 3; ++k) two.points.push_back(Point(5, k % 2, k));
  const Surface surface = surface_of_lists(two);
  const std::vector<SurfacePoint> points = {
      SurfacePoint::at_vertex(surface, VertexId{0}), SurfacePoint::at_vertex(surface, VertexId{1}),
      SurfacePoint::in_face(surface, FaceId{2}, {0.2, 0.3, 0.5})};
  try {
    StraightLines(surface).join(points, false);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    EXPECT_STREQ(error.what(),
                 "No path joins the points near vertices 1 and 4: they lie on different "
                 "components of the mesh.");
  }
}

// A gap in a stroke may be a lost part; a leg to a click is intended.
TEST(StraightLines, GapsOfStrokesDecide) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(10, 10));
  StraightLines lines(mesh.surface());
  SnappedCurve curve;
  for (const std::size_t v : {12, 13, 14, 25, 62, 63, 74}) {  // the gap is from (3, 2) to (7, 5)
    curve.points.push_back(SurfacePoint::at_vertex(mesh.surface(), VertexId{v}));
  }
  for (const bool clicked : {false, true}) {
    if (clicked) curve.way_points = {{4, 0}};
    SnappedDrawing drawing;
    drawing.add(mesh, std::span(&curve, 1), lines);
    EXPECT_EQ(drawing.warnings().size(), 1U);
    EXPECT_EQ(drawing.decisive(), clicked ? std::vector<std::string>() : drawing.warnings());
  }
}

// Clicked points are all far apart, so no part is missing between them.
TEST(StraightLines, PointsThatAreAllFarApartHaveNoGaps) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(10, 10));
  std::vector<SurfacePoint> points;
  for (const std::size_t v : {12, 16, 64, 108, 60}) {
    points.push_back(SurfacePoint::at_vertex(mesh.surface(), VertexId{v}));
  }
  StraightLines lines(mesh.surface());
  lines.join(points, false);
  EXPECT_EQ(lines.gaps().count, 0U);
}

TEST(StraightLines, BetweenTwoPointsThatAreAsNearToAVertexAsRounding) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  const Surface& surface = mesh.surface();
  const VertexId middle{12};
  std::vector<SurfacePoint> points;  // the first of opposite faces around the vertex
  const std::vector<FaceId> around = faces_at(surface, SurfacePoint::at_vertex(surface, middle));
  for (const std::size_t i : {std::size_t{0}, around.size() / 2}) {
    std::array<double, 3> at{};
    const auto corners = surface.corners(around[i]);
    for (std::size_t k = 0; k < 3; ++k) at[k] = corners[k] == middle ? 1 - 2e-12 : 1e-12;
    points.push_back(SurfacePoint::in_face(surface, around[i], at));
  }
  const SurfaceCurve line = StraightLines(surface).join(points, false);
  expect_joined(surface, line);
  ASSERT_EQ(line.points.size(), 3U);
  EXPECT_EQ(line.points[1], SurfacePoint::at_vertex(surface, middle));
}

/// The shortest way over a unit cube from (x, y) on its top to (s, t) on its front, where y is the
/// distance of the first and t that of the second point to their common edge: over this edge, or
/// by way of the left or the right side, unfolded into the plane by hand.
double shortest_over_cube(double x, double y, double s, double t) {
  return std::min(
      {std::hypot(x - s, y + t), std::hypot(y + s, x + t), std::hypot(y + 1 - s, 1 - x + t)});
}

TEST(StraightLines, AreTheShortestOverACubeOfTwelveTriangles) {
  MeshLists cube;
  for (int k = 0; k < 8; ++k) cube.points.emplace_back(k >> 2, (k >> 1) & 1, k & 1);
  cube.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  const SurfaceMesh mesh = SurfaceMesh::open(cube);
  StraightLines lines(mesh.surface());
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(0.01, 0.99);
  for (int k = 0; k < 500; ++k) {
    const double x = at(random), y = at(random), s = at(random), t = at(random);
    const std::vector<Point> ends = {Point(x, y, 1), Point(s, 0, 1 - t)};
    const SnappedCurve snapped = snap(mesh, CurveInput{false, ends, {}});
    const SurfaceCurve line = lines.join(snapped.points, false);
    expect_joined(mesh.surface(), line);
    EXPECT_NEAR(curve_length(mesh.surface(), line), shortest_over_cube(x, y, s, t), 1e-9)
        << x << " " << y << " " << s << " " << t;
  }
}

/// The length of the shortest way from (u, v) to (s, t) over an open square tube of side 1, where u
/// and s count along its girth of 4 and v and t along its axis: a straight line on the unrolled
/// tube.
double shortest_over_tube(double u, double v, double s, double t) {
  constexpr double kAround = 4;
  const double across = std::min(std::abs(u - s), kAround - std::abs(u - s));
  return std::hypot(across, v - t);
}

/// The point of the tube at u along its girth and v along its axis.
Point on_tube(double u, double v) {
  const double along = u - std::floor(u);
  switch (static_cast<int>(u)) {
    case 0:
      return {along, 0, v};
    case 1:
      return {1, along, v};
    case 2:
      return {1 - along, 1, v};
    default:
      return {0, 1 - along, v};
  }
}

MeshLists square_tube(std::uint32_t height) {
  MeshLists tube;
  for (std::uint32_t ring = 0; ring <= height; ++ring) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      tube.points.push_back(on_tube(k, ring));
      if (ring == 0) continue;
      const std::uint32_t a = 4 * (ring - 1) + k, b = 4 * (ring - 1) + (k + 1) % 4;
      tube.triangles.push_back({a, b, b + 4});
      tube.triangles.push_back({a, b + 4, a + 4});
    }
  }
  return tube;
}

/// The length of the shortest way between two points that goes along edges from a corner of the
/// first point's face to a corner of the second point's.
double shortest_along_edges(const SurfaceMesh& mesh, const SurfacePoint& from,
                            const SurfacePoint& to) {
  const auto corners = [&](const SurfacePoint& p) {
    return mesh.surface().corners(any_face(mesh.surface(), p));
  };
  double shortest = HUGE_VAL;
  for (const VertexId a : corners(from)) {
    for (const VertexId b : corners(to)) {
      std::vector<VertexId> path = {a};
      if (a != b) path = draw_edge_path(mesh.surface(), std::vector{a, b});
      double length = 0;
      Point before = mesh.position(from);
      for (const VertexId v : path) {
        const Point at = mesh.position(SurfacePoint::at_vertex(mesh.surface(), v));
        length += (at - before).norm();
        before = at;
      }
      shortest = std::min(shortest, length + (mesh.position(to) - before).norm());
    }
  }
  return shortest;
}

TEST(StraightLines, AreNoLongerThanAnyEdgePathFromCornerToCorner) {
  const SurfaceMesh mesh = SurfaceMesh::open(square_tube(3));
  StraightLines lines(mesh.surface());
  std::mt19937 random(4);
  std::uniform_real_distribution<double> around(0.01, 3.99), along(0.01, 2.99);
  for (int k = 0; k < 500; ++k) {
    const double u = around(random), v = along(random), s = around(random), t = along(random);
    const std::vector<Point> ends = {on_tube(u, v), on_tube(s, t)};
    const SnappedCurve snapped = snap(mesh, CurveInput{false, ends, {}});
    const SurfaceCurve line = lines.join(snapped.points, false);
    expect_joined(mesh.surface(), line);
    const double length = curve_length(mesh.surface(), line);
    EXPECT_GT(length, shortest_over_tube(u, v, s, t) - 1e-9);
    EXPECT_LE(length, shortest_along_edges(mesh, snapped.points[0], snapped.points[1]) + 1e-9)
        << u << " " << v << " " << s << " " << t;
  }
}

}  // namespace
}  // namespace talweg
