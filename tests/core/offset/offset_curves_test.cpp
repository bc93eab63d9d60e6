// Offsets with a known shape in the plane, on boxes and round surfaces; and their distances on
// rough surfaces.
#include "talweg/core/offset/offset_curves.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

using std::numbers::pi;

SurfaceCurve line_on(const SurfaceMesh& mesh, std::vector<Point> points, bool closed = false) {
  CurveInput input;
  input.closed = closed;
  input.points = std::move(points);
  return StraightLines(mesh.surface()).join(snap(mesh, input).points, closed);
}

OffsetResult offset(const SurfaceMesh& mesh, const SurfaceCurve& curve, double distance,
                    CurveSide side = CurveSide::kBoth, OffsetCaps caps = OffsetCaps::kRound) {
  OffsetOptions options;
  options.distances = {distance};
  options.side = side;
  options.caps = caps;
  return offset_curves(mesh, std::span(&curve, 1), options);
}

/// Expects the properties of every offset: its points have the distance, measured again; it crosses
/// nothing; neighbouring points share a face.
void expect_sound(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                  const OffsetResult& result, double tolerance) {
  PolylineDistance distance(mesh.surface());
  distance.set(curves);
  std::vector<SurfaceCurve> made;
  for (const OffsetCurve& offset : result.curves) {
    for (const SurfacePoint& point : offset.curve.points) {
      ASSERT_NEAR(distance.at(point).distance, offset.distance, tolerance);
    }
    EXPECT_LE(offset.off_max, tolerance);
    EXPECT_NEAR(offset.length, curve_length(mesh.surface(), offset.curve), 1e-12 * offset.length);
    made.push_back(offset.curve);
  }
  EXPECT_TRUE(crossing_curves(mesh.surface(), made).empty());
}
void expect_sound(const SurfaceMesh& mesh, const SurfaceCurve& curve, const OffsetResult& result,
                  double tolerance) {
  expect_sound(mesh, std::span(&curve, 1), result, tolerance);
}

TEST(OffsetCurves, GoRoundTheEndsOfALine) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  const SurfaceCurve curve = line_on(mesh, {Point(5.2, 10.3, 0), Point(14.7, 10.9, 0)});
  const double length = std::hypot(9.5, 0.6);
  for (const double d : {0.01, 0.3, 1.0, 2.3, 4.0}) {
    const OffsetResult result = offset(mesh, curve, d);
    ASSERT_EQ(result.curves.size(), 1U) << d;
    EXPECT_TRUE(result.curves[0].curve.closed);
    EXPECT_EQ(result.curves[0].side, CurveSide::kBoth);
    // The chords of the caps are shorter than arcs of radius d, but longer than arcs of radius d
    // minus the tolerance.
    EXPECT_LE(result.curves[0].length, 2 * length + 2 * pi * d + 1e-9);
    EXPECT_GE(result.curves[0].length, 2 * length + 2 * pi * (d - 1e-3 * d));
    EXPECT_TRUE(result.warnings.empty());
    expect_sound(mesh, curve, result, 1e-3 * d);
  }
}

TEST(OffsetCurves, RunAlongEdgesWhoseVerticesHaveTheDistance) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  const SurfaceCurve curve = line_on(mesh, {Point(5, 10, 0), Point(15, 10, 0)});
  const OffsetResult result = offset(mesh, curve, 2, CurveSide::kLeft);
  ASSERT_EQ(result.curves.size(), 1U);
  const SurfaceCurve& left = result.curves[0].curve;
  EXPECT_FALSE(left.closed);
  ASSERT_EQ(left.points.size(), 11U);
  for (std::size_t i = 0; i < 11; ++i) {
    const Point expected(5 + static_cast<double>(i), 12, 0);
    EXPECT_NEAR((mesh.position(left.points[i]) - expected).norm(), 0, 1e-8);
    EXPECT_TRUE(left.points[i].is_vertex());
  }
}

TEST(OffsetCurves, AreCutOffAtTheEndsWithoutCaps) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  const SurfaceCurve curve = line_on(mesh, {Point(5.2, 10.3, 0), Point(14.7, 10.3, 0)});
  const OffsetResult both = offset(mesh, curve, 2.5, CurveSide::kBoth, OffsetCaps::kNone);
  ASSERT_EQ(both.curves.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const OffsetCurve& made = both.curves[k];
    const double y = k == 0 ? 12.8 : 7.8;
    EXPECT_EQ(made.side, k == 0 ? CurveSide::kLeft : CurveSide::kRight);
    EXPECT_FALSE(made.curve.closed);
    // Distances within 1e-13 count as equal, so an arc separates from its tangent only at 1e-6.
    EXPECT_NEAR(made.length, 9.5, 5e-6);
    EXPECT_NEAR((mesh.position(made.curve.points.front()) - Point(5.2, y, 0)).norm(), 0, 5e-6);
    EXPECT_NEAR((mesh.position(made.curve.points.back()) - Point(14.7, y, 0)).norm(), 0, 5e-6);
  }
  const OffsetResult right = offset(mesh, curve, 2.5, CurveSide::kRight);
  ASSERT_EQ(right.curves.size(), 1U);
  EXPECT_EQ(right.curves[0].curve.points, both.curves[1].curve.points);
}

TEST(OffsetCurves, AreOnTheOtherSideOfTheReversedCurve) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  const SurfaceCurve curve =
      line_on(mesh, {Point(5.2, 10.3, 0), Point(10, 12.1, 0), Point(14.7, 10.3, 0)});
  SurfaceCurve back = curve;
  std::reverse(back.points.begin(), back.points.end());
  const OffsetResult left = offset(mesh, curve, 1.5, CurveSide::kLeft);
  const OffsetResult right = offset(mesh, back, 1.5, CurveSide::kRight);
  ASSERT_EQ(left.curves.size(), 1U);
  ASSERT_EQ(right.curves.size(), 1U);
  EXPECT_NEAR(left.curves[0].length, right.curves[0].length, 1e-6);
  // Outside the bend: both legs, and an arc of the angle between them.
  const double angle = 2 * std::atan2(1.8, 4.75);
  EXPECT_GT(left.curves[0].length, 2 * std::hypot(4.75, 1.8) + 1.2 * angle);
  EXPECT_LT(offset(mesh, curve, 1.5, CurveSide::kRight).curves[0].length,
            2 * std::hypot(4.75, 1.8));
}

TEST(OffsetCurves, OfAPointAreCircles) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  for (const Point& center : {Point(10, 10, 0), Point(10.5, 10, 0), Point(10.4, 9.7, 0)}) {
    CurveInput input;
    input.points = std::vector<Point>{center, center + Point(1, 0, 0)};
    SurfaceCurve curve{false, {snap(mesh, input).points.front()}};
    for (const double d : {0.05, 3.1}) {
      const OffsetResult result = offset(mesh, curve, d);
      ASSERT_EQ(result.curves.size(), 1U);
      EXPECT_TRUE(result.curves[0].curve.closed);
      EXPECT_NEAR(result.curves[0].length, 2 * pi * d, 2 * pi * d * 1e-3);
      for (const Point& p : positions_of(mesh, result.curves[0].curve)) {
        EXPECT_NEAR((p - center).norm(), d, 1e-9);
      }
    }
  }
}

TEST(OffsetCurves, LieInOneFaceWhereTheCurveDoes) {
  MeshLists lists = test::grid(1, 1);
  for (Point& p : lists.points) p *= 100;
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const SurfaceCurve curve = line_on(mesh, {Point(60, 20, 0), Point(70, 20, 0)});
  ASSERT_EQ(curve.points.size(), 2U);
  for (const double d : {0.01, 1.0, 5.0}) {
    const OffsetResult result = offset(mesh, curve, d);
    ASSERT_EQ(result.curves.size(), 1U) << d;
    EXPECT_NEAR(result.curves[0].length, 20 + 2 * pi * d, 2e-3 * pi * d);
    expect_sound(mesh, curve, result, 1e-3 * d);
  }
}

TEST(OffsetCurves, FindAPocketInsideOneFace) {
  MeshLists lists = test::grid(1, 1);
  for (Point& p : lists.points) p *= 100;
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  // A square with an inscribed circle of radius 5.
  const SurfaceCurve curve =
      line_on(mesh, {Point(60, 20, 0), Point(70, 20, 0), Point(70, 30, 0), Point(60, 30, 0)}, true);
  const OffsetResult result = offset(mesh, curve, 4.9, CurveSide::kLeft);
  ASSERT_EQ(result.curves.size(), 1U);
  EXPECT_TRUE(result.curves[0].curve.closed);
  EXPECT_NEAR(result.curves[0].length, 4 * 0.2, 8 * 4.9e-3);
  const OffsetResult outside = offset(mesh, curve, 4.9, CurveSide::kRight);
  ASSERT_EQ(outside.curves.size(), 1U);
  EXPECT_NEAR(outside.curves[0].length, 40 + 2 * pi * 4.9, 2 * pi * 4.9e-3);
  EXPECT_EQ(offset(mesh, curve, 4.9).curves.size(), 2U);
}

TEST(OffsetCurves, RunIntoTheBoundary) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  const SurfaceCurve curve = line_on(mesh, {Point(0, 10.3, 0), Point(20, 11.7, 0)});
  const OffsetResult result = offset(mesh, curve, 2.5);
  ASSERT_EQ(result.curves.size(), 2U);
  EXPECT_EQ(result.curves[0].side, CurveSide::kLeft);
  EXPECT_EQ(result.curves[1].side, CurveSide::kRight);
  for (const OffsetCurve& made : result.curves) {
    EXPECT_FALSE(made.curve.closed);
    EXPECT_NEAR(mesh.position(made.curve.points.front()).x(), 0, 1e-12);
    EXPECT_NEAR(mesh.position(made.curve.points.back()).x(), 20, 1e-12);
  }
  // The curve meets the boundary at an angle. On the right of its beginning the nearest point is
  // the end of the curve, on the left a point of the segment.
  const double slant = std::hypot(20, 1.4) / 20;
  EXPECT_NEAR(mesh.position(result.curves[0].curve.points.front()).y(), 10.3 + 2.5 * slant, 1e-8);
  EXPECT_NEAR(mesh.position(result.curves[1].curve.points.front()).y(), 10.3 - 2.5, 1e-8);
  EXPECT_EQ(offset(mesh, curve, 2.5, CurveSide::kLeft).curves.size(), 1U);
  expect_sound(mesh, curve, result, 2.5e-3);
}

TEST(OffsetCurves, SplitInANeck) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(26, 12));
  // Two squares of side 8 with a neck of width 2 between them, counterclockwise.
  std::vector<Point> corners = {Point(0, 0, 0),  Point(8, 0, 0),  Point(8, 3, 0),  Point(14, 3, 0),
                                Point(14, 0, 0), Point(22, 0, 0), Point(22, 8, 0), Point(14, 8, 0),
                                Point(14, 5, 0), Point(8, 5, 0),  Point(8, 8, 0),  Point(0, 8, 0)};
  for (Point& p : corners) p += Point(2.13, 1.91, 0);
  const SurfaceCurve curve = line_on(mesh, corners, true);
  const OffsetResult wide = offset(mesh, curve, 0.9, CurveSide::kLeft);
  EXPECT_EQ(wide.curves.size(), 1U);
  const OffsetResult split = offset(mesh, curve, 1.5, CurveSide::kLeft);
  ASSERT_EQ(split.curves.size(), 2U);
  // Three sides of length 5, two parts of the fourth side, and two arcs around the corners of the
  // neck that meet on its axis.
  const double length = 15 + 3 + 2 * 1.5 * std::asin(1 / 1.5);
  for (const OffsetCurve& made : split.curves) {
    EXPECT_TRUE(made.curve.closed);
    EXPECT_NEAR(made.length, length, 0.02);
  }
  expect_sound(mesh, curve, split, 1.5e-3);
}

TEST(OffsetCurves, GoAroundTheCornerOfABox) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::box());
  const SurfaceCurve corner{false, {SurfacePoint::at_vertex(mesh.surface(), VertexId{0})}};
  const OffsetResult circle = offset(mesh, corner, 0.7);
  ASSERT_EQ(circle.curves.size(), 1U);
  EXPECT_NEAR(circle.curves[0].length, 1.5 * pi * 0.7, 1.5 * pi * 0.7e-3);
  // Halfway around the box: 0.5 to the rim, then 0.3 over the top and the bottom.
  const SurfaceCurve girdle =
      line_on(mesh, {Point(0, 0, 0.5), Point(1, 0, 0.5), Point(1, 1, 0.5), Point(0, 1, 0.5)}, true);
  const OffsetResult result = offset(mesh, girdle, 0.8);
  ASSERT_EQ(result.curves.size(), 2U);
  EXPECT_EQ(result.curves[0].side, CurveSide::kLeft);
  EXPECT_EQ(result.curves[1].side, CurveSide::kRight);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(result.curves[k].length, 1.6, 8 * 0.8e-3);
    for (const Point& p : positions_of(mesh, result.curves[k].curve)) {
      EXPECT_NEAR(p.z(), k == 0 ? 1 : 0, 1e-9);
    }
  }
}

TEST(OffsetCurves, AreCirclesOfLatitudeOnASphere) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(5));
  std::vector<Point> equator;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * pi * i / 64;
    equator.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  const SurfaceCurve curve = line_on(mesh, equator, true);
  const OffsetResult result = offset(mesh, curve, 0.8);
  ASSERT_EQ(result.curves.size(), 2U);
  // Edges are 0.05 long, so the mesh is within 3e-4 of the sphere, and distances differ by as much.
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(result.curves[k].length, 2 * pi * std::cos(0.8), 0.01);
    for (const Point& p : positions_of(mesh, result.curves[k].curve)) {
      EXPECT_NEAR(p.z(), k == 0 ? std::sin(0.8) : -std::sin(0.8), 2e-3);
    }
  }
  expect_sound(mesh, curve, result, 0.8e-3);
}

TEST(OffsetCurves, LieOnBothSidesOfACurveThatDoesNotSeparate) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::torus(40, 60));
  std::vector<VertexId> around;
  for (std::uint32_t i = 0; i < 40; ++i) around.emplace_back(i);
  const SurfaceCurve curve = test::vertex_curve(mesh.surface(), around, true);
  const OffsetResult result = offset(mesh, curve, 1.5);
  ASSERT_EQ(result.curves.size(), 2U);
  EXPECT_EQ(result.curves[0].side, CurveSide::kLeft);
  EXPECT_EQ(result.curves[1].side, CurveSide::kRight);
  EXPECT_TRUE(result.curves[0].curve.closed && result.curves[1].curve.closed);
  expect_sound(mesh, curve, result, 1.5e-3);
}

TEST(OffsetCurves, GiveTheReasonIfThereAreNone) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  const SurfaceCurve curve = line_on(mesh, {Point(0, 5, 0), Point(20, 5, 0)});
  const OffsetResult far = offset(mesh, curve, 30);
  EXPECT_TRUE(far.curves.empty());
  ASSERT_EQ(far.warnings.size(), 1U);
  EXPECT_EQ(far.warnings[0],
            "No point of the surface is at the distance 30: the farthest vertex is 15 away.");
  const OffsetResult left = offset(mesh, curve, 10, CurveSide::kLeft);
  EXPECT_EQ(left.curves.size(), 1U);
  const OffsetResult right = offset(mesh, curve, 10, CurveSide::kRight);
  ASSERT_EQ(right.warnings.size(), 1U);
  EXPECT_EQ(right.warnings[0], "Nothing at the distance 10 lies on the right of the curve.");
}

TEST(OffsetCurves, RejectBadOptions) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(2, 2));
  const SurfaceCurve curve = line_on(mesh, {Point(0.5, 0.4, 0), Point(1.5, 0.4, 0)});
  OffsetOptions options;
  EXPECT_THROW(offset_curves(mesh, std::span(&curve, 1), options), Error);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.distances = {bad};
    EXPECT_THROW(offset_curves(mesh, std::span(&curve, 1), options), Error) << bad;
  }
  options.distances = {0.1};
  EXPECT_THROW(offset_curves(mesh, {}, options), Error);
  options.tolerance = 0;
  EXPECT_THROW(offset_curves(mesh, std::span(&curve, 1), options), Error);
}

/// A grid with hills and random diagonals' worth of noise.
SurfaceMesh rough_mesh(unsigned seed, double scale = 1) {
  MeshLists lists = test::grid(24, 24);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> noise(-0.3, 0.3);
  for (Point& p : lists.points) {
    p += Point(noise(engine), noise(engine), 2 * noise(engine) + 3 * std::sin(p.x() / 4));
    p *= scale;
  }
  return SurfaceMesh::open(lists);
}

TEST(OffsetCurves, HaveTheDistanceOnRoughSurfaces) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const SurfaceMesh mesh = rough_mesh(seed);
    const std::vector<SurfaceCurve> curves = {
        line_on(mesh,
                {mesh.point(VertexId{160}), mesh.point(VertexId{390}), mesh.point(VertexId{460})}),
        line_on(mesh, {mesh.point(VertexId{200}), mesh.point(VertexId{220})})};
    OffsetOptions options;
    options.distances = {0.1, 0.9, 2.5, 5};
    const OffsetResult result = offset_curves(mesh, curves, options);
    EXPECT_GE(result.curves.size(), 4U);
    expect_sound(mesh, curves, result, 5e-3);
  }
}

/// An offset has as many crossings with an edge as the distance has sign changes along the edge.
TEST(OffsetCurves, CrossEveryEdgeWhereTheDistanceDoes) {
  const SurfaceMesh mesh = rough_mesh(9);
  const Surface& surface = mesh.surface();
  const SurfaceCurve curve = line_on(mesh, {mesh.point(VertexId{160}), mesh.point(VertexId{390}),
                                            mesh.point(VertexId{460}), mesh.point(VertexId{420})});
  const double d = 2.1;
  const OffsetResult result = offset(mesh, curve, d);
  std::vector<int> crossings(surface.edge_count(), 0);
  for (const OffsetCurve& made : result.curves) {
    for (const SurfacePoint& point : made.curve.points) {
      if (const auto* at = std::get_if<OnEdge>(&point.where())) ++crossings[at->edge.index()];
    }
  }
  PolylineDistance distance(surface);
  distance.set(std::span(&curve, 1));
  int total = 0;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    int changes = 0;
    bool near = distance.on_edge(EdgeId{e}, 0).distance <= d;
    for (int i = 1; i <= 50; ++i) {
      const bool now = distance.on_edge(EdgeId{e}, i / 50.0).distance <= d;
      changes += now != near ? 1 : 0;
      near = now;
    }
    EXPECT_GE(crossings[e], changes) << e;
    total += changes;
  }
  EXPECT_GT(total, 50);
}

TEST(OffsetCurves, ScaleWithTheMesh) {
  const SurfaceMesh mesh = rough_mesh(3), large = rough_mesh(3, 1e6);
  const auto curve = [](const SurfaceMesh& on) {
    return line_on(on, {on.point(VertexId{160}), on.point(VertexId{390})});
  };
  const OffsetResult a = offset(mesh, curve(mesh), 1.7), b = offset(large, curve(large), 1.7e6);
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t k = 0; k < a.curves.size(); ++k) {
    EXPECT_NEAR(b.curves[k].length, 1e6 * a.curves[k].length, 1e-3 * b.curves[k].length);
    EXPECT_EQ(a.curves[k].side, b.curves[k].side);
  }
}

TEST(OffsetCurves, AreTheSameInASecondRun) {
  const SurfaceMesh mesh = rough_mesh(4);
  const SurfaceCurve curve = line_on(mesh, {mesh.point(VertexId{160}), mesh.point(VertexId{390})});
  const OffsetResult a = offset(mesh, curve, 1.7), b = offset(mesh, curve, 1.7);
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t k = 0; k < a.curves.size(); ++k) {
    EXPECT_EQ(a.curves[k].curve.points, b.curves[k].curve.points);
  }
}

TEST(OffsetCurves, AreCancelled) {
  const SurfaceMesh mesh = rough_mesh(4);
  const SurfaceCurve curve = line_on(mesh, {mesh.point(VertexId{160}), mesh.point(VertexId{390})});
  OffsetOptions options;
  options.distances = {3};
  EXPECT_THROW(
      offset_curves(mesh, std::span(&curve, 1), options, [](const char*, double) { return false; }),
      Cancelled);
}

}  // namespace
}  // namespace talweg
