// The meaning of the points of a drawing follows from the drawing, or from the user.
#include "talweg/core/drawing/marked_points.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class MarkedPointsTest : public testing::Test {
 protected:
  /// Vertices along the lowest row.
  static CurveInput row(std::initializer_list<std::uint32_t> ids) {
    CurveInput curve;
    curve.points = test::ids(ids);
    return curve;
  }
  [[nodiscard]] SurfacePoint at(std::uint32_t v) const {
    return SurfacePoint::at_vertex(mesh.surface(), VertexId{v});
  }
  [[nodiscard]] SnappedDrawing drawing(const std::vector<CurveInput>& curves) const {
    SnappedDrawing result;
    StraightLines lines(mesh.surface());
    result.add(mesh, snap(mesh, curves), lines, {});
    return result;
  }
  /// Control points along the lowest row of the sheet, at a distance `apart`.
  [[nodiscard]] static CurveInput controls(std::size_t count, double apart) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
      points.emplace_back(0.1 + apart * static_cast<double>(k), 0.5, 0);
    }
    CurveInput curve;
    curve.points = points;
    curve.control_points = true;
    return curve;
  }
  static std::vector<SurfacePoint> points_of(const std::vector<WayPoint>& ways) {
    std::vector<SurfacePoint> points;
    for (const WayPoint& way : ways) points.push_back(way.point);
    return points;
  }

  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(500, 2));
  static constexpr double kEdge = (1 + 1 + std::numbers::sqrt2) / 3;  // mean edge length
};

TEST_F(MarkedPointsTest, FollowTheMarksOfTheDrawing) {
  CurveInput named = row({0, 1, 2, 3}), other = row({10, 11, 12});
  named.way_points = {{0, 0}, {3, 0.25}};
  named.painted = {1};
  const SnappedDrawing drawn = drawing({named, other});

  MarkedPoints marked = marked_points(drawn, {});
  EXPECT_EQ(points_of(marked.way_points), (std::vector{at(0), at(3)}));
  EXPECT_EQ(marked.way_points[1].tolerance, 0.25);
  EXPECT_EQ(marked.painted, std::vector{at(1)});

  // A curve that names way-points keeps them; all points of the other curve become way-points.
  marked = marked_points(drawn, {PointMeaning::kExact, {}, 0});
  EXPECT_EQ(points_of(marked.way_points), (std::vector{at(0), at(3), at(10), at(11), at(12)}));

  marked = marked_points(drawn, {PointMeaning::kRough, {}, 0});
  EXPECT_TRUE(marked.way_points.empty());
  EXPECT_TRUE(marked.painted.empty());

  marked = marked_points(drawn, {PointMeaning::kGiven, {at(2)}, 0.5});
  EXPECT_EQ(points_of(marked.way_points), std::vector{at(2)});
  EXPECT_EQ(marked.way_points[0].tolerance, 0.5);
}

TEST_F(MarkedPointsTest, TheToleranceAppliesToWayPointsWithoutATolerance) {
  CurveInput named = row({0, 1, 2, 3});
  named.way_points = {{0, 0}, {3, 0.25}};
  const MarkedPoints marked = marked_points(drawing({named}), {PointMeaning::kGiven, {}, 0.5});
  EXPECT_EQ(marked.way_points[0].tolerance, 0.5);
  EXPECT_EQ(marked.way_points[1].tolerance, 0.25);
}

TEST_F(MarkedPointsTest, ExactLeavesOutPaintedPoints) {
  CurveInput painted = row({0, 1, 2, 3, 4});
  painted.painted = {1, 3};
  const MarkedPoints marked = marked_points(drawing({painted}), {PointMeaning::kExact, {}, 0});
  EXPECT_EQ(points_of(marked.way_points), (std::vector{at(0), at(2), at(4)}));
}

TEST_F(MarkedPointsTest, ADrawingIsFreeIfAllOfItLiesBetweenWayPoints) {
  CurveInput legs = row({0, 1, 2, 3}), stroke = row({10, 11, 12});
  legs.way_points = {{0, 0}, {3, 0}};
  const auto is_free = [&](const std::vector<CurveInput>& curves) {
    const SnappedDrawing drawn = drawing(curves);
    return only_way_points(drawn.curves, marked_points(drawn, {}));
  };
  EXPECT_TRUE(is_free({legs}));
  EXPECT_FALSE(is_free({legs, stroke}));
  legs.painted = {2};
  EXPECT_FALSE(is_free({legs}));
  EXPECT_FALSE(is_free({stroke}));
}

TEST_F(MarkedPointsTest, CoincidingPointsCombineTheirMarks) {
  CurveInput curve;
  curve.points = std::vector<Point>{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {4, 0, 0}};
  curve.way_points = {{0, 0.5}, {1, 0.25}};
  curve.painted = {1, 3};
  const SnappedCurve snapped = snap(mesh, curve);
  ASSERT_EQ(snapped.points.size(), 3U);
  ASSERT_EQ(snapped.way_points.size(), 1U);
  EXPECT_EQ(snapped.way_points[0].point, 0U);
  EXPECT_EQ(snapped.way_points[0].tolerance, 0.25);
  EXPECT_EQ(snapped.painted, std::vector<std::size_t>{1});  // a way-point is not painted
}

TEST_F(MarkedPointsTest, MarksOfMissingPointsAreRefused) {
  const auto sentence = [&](const CurveInput& curve) {
    try {
      snap(mesh, curve);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
      return std::string(error.what());
    }
    return std::string("no error");
  };
  CurveInput curve = row({0, 1, 2});
  curve.way_points = {{3, 0}};
  EXPECT_NE(sentence(curve).find("no point 3 that could be a way-point"), std::string::npos);
  curve.way_points = {{1, -0.5}};
  EXPECT_NE(sentence(curve).find("must be 0 or more, not -0.5"), std::string::npos);
  curve.way_points = {{1, std::nan("")}};
  EXPECT_NE(sentence(curve).find("must be 0 or more, not nan"), std::string::npos);
  curve.way_points.clear();
  curve.painted = {9};
  EXPECT_NE(sentence(curve).find("no point 9 that could be painted"), std::string::npos);
}

TEST_F(MarkedPointsTest, FewControlPointsFarApartAreWayPoints) {
  for (const auto& [count, apart] :
       {std::pair{5, 3.0}, {2, 10.0}, {200, 2.4}, {10, 2.01 * kEdge}}) {
    const SnappedCurve snapped = snap(mesh, controls(static_cast<std::size_t>(count), apart));
    EXPECT_EQ(snapped.why_stroke, "");
    EXPECT_EQ(snapped.way_points.size(), static_cast<std::size_t>(count));
  }
}

TEST_F(MarkedPointsTest, ManyOrDenseControlPointsAreAStrokeWithAWarning) {
  const auto warnings = [&](const CurveInput& curve, const PointOptions& how = {}) {
    const SnappedDrawing drawn = drawing({curve});
    EXPECT_TRUE(drawn.way_points.empty());
    return stroke_warnings(drawn, how);
  };
  const auto many = warnings(controls(201, 2.4));
  ASSERT_EQ(many.size(), 1U);
  EXPECT_NE(many[0].find("has 201 control points; more than 200"), std::string::npos) << many[0];
  const auto dense = warnings(controls(10, 1.98 * kEdge));
  ASSERT_EQ(dense.size(), 1U);
  EXPECT_NE(dense[0].find("closer than 2 they are taken as a stroke"), std::string::npos)
      << dense[0];
  // A meaning given by the user needs no warning.
  EXPECT_TRUE(warnings(controls(201, 2.4), {PointMeaning::kExact, {}, 0}).empty());
  EXPECT_TRUE(warnings(controls(201, 2.4), {PointMeaning::kRough, {}, 0}).empty());
}

TEST_F(MarkedPointsTest, ManyControlPointsCanBeMadeExact) {
  const SnappedDrawing drawn = drawing({controls(201, 2.4)});
  EXPECT_EQ(marked_points(drawn, {PointMeaning::kExact, {}, 0}).way_points.size(), 201U);
}

}  // namespace
}  // namespace talweg
