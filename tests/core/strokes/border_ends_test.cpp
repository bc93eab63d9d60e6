// Strokes that cross the boundary of an open sheet, or stop a little before it.
#include "talweg/core/strokes/border_ends.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/mesh/border_points.hpp"
#include "talweg/core/strokes/drawn_loops.hpp"
#include "talweg/talweg.hpp"

namespace talweg::border_ends_test {
namespace {

/// Points from a to b, at most `step` apart.
std::vector<Point> line(const Point& a, const Point& b, double step) {
  const auto n = static_cast<int>(std::ceil((b - a).norm() / step));
  std::vector<Point> points;
  for (int k = 0; k <= n; ++k) points.emplace_back(a + (b - a) * k / n);
  return points;
}

/// The sheet [0, 20]².
class BorderEnds : public testing::Test {
 protected:
  [[nodiscard]] SnappedCurve snapped(std::vector<Point> points) const {
    return snap(mesh, {false, std::move(points), {}});
  }
  SnappedDrawing drawing_of(std::vector<SnappedCurve> curves) {
    SnappedDrawing drawing;
    drawing.add(mesh, curves, lines);
    return drawing;
  }
  void expect_refused(const std::vector<Point>& points, const std::string& words) const {
    try {
      (void)snapped(points);
      ADD_FAILURE() << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
  void expect_both_ends_at(const SurfaceCurve& curve, const Point& start, const Point& end) const {
    expect_at(curve.points.front(), start);
    expect_at(curve.points.back(), end);
    EXPECT_NEAR(curve_length(mesh.surface(), curve), (end - start).norm(), 1e-9);
  }
  SurfaceCurve straight(const Point& a, const Point& b) {
    return lines.join(snapped({a, b}).points, false);
  }
  SnappedDrawing led(const SurfaceCurve& curve) {
    SnappedDrawing drawing;
    drawing.curves.push_back(curve);
    return with_ends_at_border(mesh, drawing, lines);
  }
  void expect_at(const SurfacePoint& point, const Point& where) const {
    EXPECT_LT((mesh.position(point) - where).norm(), 1e-9) << mesh.position(point).transpose();
    EXPECT_TRUE(is_on_boundary(mesh.surface(), point));
  }

  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(20, 20));
  StraightLines lines{mesh.surface()};
};

TEST_F(BorderEnds, AStrokeOverBothEdgesEndsExactlyOnThem) {
  const SnappedCurve stroke = snapped(line({-3, 10.3, 0}, {22, 10.3, 0}, 0.5));
  EXPECT_EQ(stroke.beyond_border[0].points, 6U);  // x from -3 to -0.5
  EXPECT_EQ(stroke.beyond_border[1].points, 4U);  // x from 20.5 to 22
  EXPECT_NEAR(stroke.beyond_border[0].farthest, 3, 1e-12);
  EXPECT_NEAR(stroke.beyond_border[1].farthest, 2, 1e-12);
  EXPECT_LT(stroke.largest_snap_distance, 1e-9);
  EXPECT_TRUE(stroke.of_hand);
  EXPECT_FALSE(stroke.may_be_loop);
  const SnappedDrawing drawing = drawing_of({stroke});
  expect_both_ends_at(drawing.curves[0], {0, 10.3, 0}, {20, 10.3, 0});
  ASSERT_EQ(drawing.notes.size(), 2U);
  EXPECT_EQ(drawing.notes[0],
            "Curve 0 runs over the border of the mesh at its start: 6 points up to 3 mesh units "
            "beyond the border are left out, and the curve begins exactly at the border.");
  EXPECT_EQ(drawing.notes[1],
            "Curve 0 runs over the border of the mesh at its end: 4 points up to 2 mesh units "
            "beyond the border are left out, and the curve ends exactly at the border.");
}

TEST_F(BorderEnds, AStrokeEndsWhereItLeavesTheMesh) {
  // The stroke passes (0, 8) at 27 degrees; the boundary point nearest to its beginning is (0, 6).
  const SnappedCurve stroke = snapped(line({-4, 6, 0}, {16, 16, 0}, 0.7));
  expect_at(stroke.points.front(), {0, 8, 0});
  EXPECT_EQ(stroke.beyond_border[1].points, 0U);
}

TEST_F(BorderEnds, AStrokeAlongTheBorderStays) {
  std::vector<Point> points;
  for (double x = 2; x <= 18; x += 0.25) points.emplace_back(x, -0.05 * std::cos(0.5 * x - 1), 0);
  const SnappedCurve stroke = snapped(points);
  EXPECT_EQ(stroke.beyond_border[0].points, 0U);
  EXPECT_NEAR(mesh.position(stroke.points.front()).x(), 2, 1e-9);
  EXPECT_NEAR(mesh.position(stroke.points.back()).x(), 18, 1e-9);
}

TEST_F(BorderEnds, AStrokeBesideTheMeshStays) {
  const SnappedCurve stroke = snapped(line({-1, 2, 0}, {-1, 9, 0}, 0.5));
  EXPECT_EQ(stroke.beyond_border[0].points, 0U);
  expect_at(stroke.points.front(), {0, 2, 0});
  expect_at(stroke.points.back(), {0, 9, 0});
}

TEST_F(BorderEnds, ALineFarBeyondTheMeshIsCutOffUnlessMostOfItIs) {
  // An eighth of the diagonal is 3.5, ten edges are 11.4.
  expect_at(snapped(line({-14, 10, 0}, {20, 10, 0}, 1)).points.front(), {0, 10, 0});
  expect_refused(line({-40, 10, 0}, {20, 10, 0}, 1), "At position 0 of the curve");
}

TEST_F(BorderEnds, ErrorsNumberPositionsAsGiven) {
  std::vector<Point> points = line({-3, 10, 0}, {20, 10, 0}, 1);
  points[12].y() = std::numeric_limits<double>::quiet_NaN();
  expect_refused(points, "At position 12 of");
  points[0].x() = -std::numeric_limits<double>::infinity();
  expect_refused(points, "At position 0 of");
}

TEST_F(BorderEnds, PaintedPointsKeepTheirPlaces) {
  CurveInput input{false, line({-3, 10, 0}, {22, 10, 0}, 1), {}};
  input.painted.resize(26);
  std::iota(input.painted.begin(), input.painted.end(), 0U);
  const SnappedCurve stroke = snap(mesh, input);
  EXPECT_EQ(stroke.points.size(), 21U);  // x from 0 to 20
  EXPECT_EQ(stroke.painted.size(), 21U);
  input.painted = {5, 26};
  EXPECT_THROW((void)snap(mesh, input), Error);
  input.painted = {5};
  const SnappedCurve one = snap(mesh, input);
  ASSERT_EQ(one.painted.size(), 1U);
  EXPECT_NEAR(mesh.position(one.points[one.painted[0]]).x(), 2, 1e-12);
}

TEST_F(BorderEnds, ClicksBeyondTheBorderStay) {
  CurveInput input{false, line({-3, 10, 0}, {10, 10, 0}, 1), {}};
  input.way_points = {{1, 0}};
  EXPECT_EQ(snap(mesh, input).beyond_border[0].points, 0U);
  input.way_points.clear();
  input.pins = {0};
  EXPECT_EQ(snap(mesh, input).beyond_border[0].points, 0U);
}

TEST_F(BorderEnds, EndsJustShortAreExtendedToTheBoundaryWithASentence) {
  const SnappedDrawing drawing = led(straight({1.5, 10.3, 0}, {18.2, 10.3, 0}));
  expect_both_ends_at(drawing.curves[0], {0, 10.3, 0}, {20, 10.3, 0});
  ASSERT_EQ(drawing.notes.size(), 2U);
  EXPECT_EQ(drawing.notes[0],
            "The start of curve 0 lies 1.5 mesh units from the border of the mesh; the curve was "
            "extended straight to the border.");
  EXPECT_EQ(drawing.notes[1],
            "The end of curve 0 lies 1.8 mesh units from the border of the mesh; the curve was "
            "extended straight to the border.");
}

TEST_F(BorderEnds, EndsWithinTwoEdgesAreExtended) {
  // A third of the edges are diagonals: the mean edge length is 1.138.
  expect_at(led(straight({2.2, 10, 0}, {12, 10, 0})).curves[0].points.front(), {0, 10, 0});
  const SurfaceCurve far = straight({2.4, 10, 0}, {12, 10, 0});
  const SnappedDrawing drawing = led(far);
  EXPECT_EQ(drawing.curves[0].points, far.points);
  EXPECT_TRUE(drawing.notes.empty());
}

TEST_F(BorderEnds, AShortCurveIsNotDoubled) {
  const SurfaceCurve spur = straight({10, 0, 0}, {10, 2, 0});  // from the boundary inwards
  EXPECT_EQ(led(spur).curves[0].points, spur.points);
}

TEST_F(BorderEnds, LoopsStayUnchanged) {
  SurfaceCurve loop = lines.join(snapped({{1, 1, 0}, {4, 1, 0}, {4, 4, 0}}).points, true);
  EXPECT_EQ(led(loop).curves[0].points, loop.points);
}

TEST_F(BorderEnds, AnEndOnAnotherCurveStays) {
  SnappedDrawing drawing;
  drawing.curves = {straight({1, 2, 0}, {1, 9, 0}), straight({1, 9, 0}, {12, 9, 0})};
  const SnappedDrawing after = with_ends_at_border(mesh, drawing, lines);
  EXPECT_EQ(after.curves[1].points, drawing.curves[1].points);
  expect_at(after.curves[0].points.front(), {0, 2, 0});
  EXPECT_EQ(after.curves[0].points.back(), drawing.curves[0].points.back());
}

TEST_F(BorderEnds, OtherCurvesStayIfOnlyStrokesAreExtended) {
  const SnappedCurve stroke = snapped(line({1.5, 10, 0}, {15, 10, 0}, 0.5));
  SnappedCurve given{false, snapped(line({1.5, 14, 0}, {15, 14, 0}, 0.5)).points};
  const SnappedDrawing drawing =
      with_ends_at_border(mesh, drawing_of({stroke, given}), lines, ExtendedCurves::kStrokes);
  expect_at(drawing.curves[0].points.front(), {0, 10, 0});
  EXPECT_EQ(drawing.curves[1].points.front(), given.points.front());
}

TEST_F(BorderEnds, AFastHandAllowsLargerGaps) {
  const SurfaceMesh strip = SurfaceMesh::open(test::grid(80, 10));
  StraightLines own(strip.surface());
  const SnappedCurve stroke = snap(strip, {false, line({4, 5, 0}, {76, 5, 0}, 3), {}});
  SnappedDrawing drawing;
  drawing.add(strip, std::span(&stroke, 1), own);
  const SurfaceCurve led = with_ends_at_border(strip, drawing, own).curves[0];
  EXPECT_NEAR(curve_length(strip.surface(), led), 80, 1e-9);
  drawing.hand_steps.clear();  // a curve from a file: a gap of four edges is too large
  EXPECT_NEAR(curve_length(strip.surface(), with_ends_at_border(strip, drawing, own).curves[0]), 72,
              1e-9);
}

TEST(BorderEndsOfSheets, TheBorderOfAnotherSheetIsNotTaken) {
  MeshLists both = test::grid(20, 20);
  const auto before = static_cast<std::uint32_t>(both.points.size());
  const MeshLists upper = test::grid(5, 5);
  for (const Point& p : upper.points) both.points.push_back(p + Point(7, 7, 0.1));
  for (const Triangle& t : upper.triangles) {
    both.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  }
  const SurfaceMesh mesh = SurfaceMesh::open(both);
  StraightLines lines(mesh.surface());
  const auto at = [&](std::uint32_t v) {
    return SurfacePoint::at_vertex(mesh.surface(), VertexId{v});
  };
  SnappedDrawing drawing;
  const std::vector<SurfacePoint> ends = {at(10 * 21 + 6), at(3 * 21 + 6)};
  drawing.curves = {lines.join(ends, false)};
  const SnappedDrawing after = with_ends_at_border(mesh, drawing, lines);
  EXPECT_EQ(after.curves[0].points, drawing.curves[0].points);
}

TEST(BorderEndsNames, AreTwo) {
  EXPECT_EQ(border_ends("snap"), talweg::BorderEnds::kSnap);
  EXPECT_EQ(border_ends("leave"), talweg::BorderEnds::kLeave);
  EXPECT_THROW(border_ends("cut"), Error);
}

}  // namespace
}  // namespace talweg::border_ends_test
