// Drawing by clicks: a curve and its way-points in one call.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class Draw : public testing::Test {
 protected:
  [[nodiscard]] const Surface& surface() const { return opened->surface(); }
  [[nodiscard]] static VertexId at(std::uint32_t x, std::uint32_t y) {
    return VertexId{21 * y + x};
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(20, 20));
  const std::vector<VertexId> clicks{at(2, 3), at(11, 7), at(17, 4)};
};

TEST_F(Draw, ThroughVerticesAlongEdgesOrStraight) {
  DrawOptions options;
  options.straight = false;
  const Drawing edges = draw(surface(), clicks, options);
  for (const SurfacePoint& point : edges.curve.points) EXPECT_TRUE(point.is_vertex());
  // By default segments between way-points are straight, and a stroke runs along edges.
  const Drawing straight = draw(surface(), clicks);
  options.straight.reset();
  options.tolerance.reset();
  EXPECT_EQ(draw(surface(), clicks, options).curve.points, edges.curve.points);
  EXPECT_NEAR(curve_length(surface(), straight.curve), std::hypot(9, 4) + std::hypot(6, 3), 1e-9);
  for (const Drawing* drawing : {&edges, &straight}) {
    ASSERT_EQ(drawing->way_points.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(drawing->way_points[k], (WayPoint{SurfacePoint::at_vertex(surface(), clicks[k])}));
    }
  }
}

TEST_F(Draw, ThroughPointsAnywhereAndTheSmootherPassesThem) {
  std::vector<SurfacePoint> points;
  for (const std::uint32_t f : {50U, 400U, 250U, 120U}) {
    points.push_back(SurfacePoint::in_face(surface(), FaceId{f}, {0.2, 0.3, 0.5}));
  }
  DrawOptions options;
  options.closed = true;
  const Drawing drawing = draw(surface(), points, options);
  EXPECT_TRUE(drawing.curve.closed);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawing);
  const SurfaceCurve result = smoother.smooth(1).curve();
  for (const SurfacePoint& point : points) {
    EXPECT_NE(std::find(result.points.begin(), result.points.end(), point), result.points.end());
  }
}

TEST_F(Draw, ClicksMayHaveAToleranceOrBeAStroke) {
  DrawOptions options;
  options.tolerance = 0.5;
  const Drawing near = draw(surface(), clicks, options);
  ASSERT_EQ(near.way_points.size(), clicks.size());
  for (const WayPoint& way : near.way_points) EXPECT_EQ(way.tolerance, 0.5);
  options.tolerance.reset();
  EXPECT_TRUE(draw(surface(), clicks, options).way_points.empty());
}

TEST_F(Draw, RefusesInvalidDrawings) {
  const auto code = [&](std::size_t count, double tolerance) {
    DrawOptions options;
    options.tolerance = tolerance;
    try {
      draw(surface(), std::span(clicks).first(count), options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kNumerical;
  };
  EXPECT_EQ(code(0, 0), ErrorCode::kBadCurve);
  EXPECT_EQ(code(1, 0), ErrorCode::kBadCurve);
  EXPECT_EQ(code(3, -1), ErrorCode::kBadUsage);
  EXPECT_EQ(code(3, std::numeric_limits<double>::quiet_NaN()), ErrorCode::kBadUsage);
}

}  // namespace
}  // namespace talweg
