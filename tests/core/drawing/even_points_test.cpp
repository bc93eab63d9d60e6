// Equal steps along curves whose lengths are known.
#include "talweg/core/drawing/even_points.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class Resampling : public testing::Test {
 protected:
  [[nodiscard]] SurfacePoint at(std::size_t v) const {
    return SurfacePoint::at_vertex(mesh_.surface(), VertexId{v});
  }
  /// The boundary of a square of side 1, by vertices of a grid of 3 x 3 squares.
  [[nodiscard]] SurfaceCurve square() const { return {true, {at(0), at(1), at(5), at(4)}}; }
  /// The lower side of the grid, of length 3.
  [[nodiscard]] SurfaceCurve side() const { return {false, {at(0), at(1), at(2), at(3)}}; }

  const SurfaceMesh mesh_ = SurfaceMesh::open(test::grid(3, 3));
};

TEST_F(Resampling, AnOpenCurveKeepsItsEnds) {
  const ResampledCurve five = resampled(mesh_, side(), {5, 0});
  EXPECT_FALSE(five.curve.closed);
  EXPECT_DOUBLE_EQ(five.spacing, 0.75);
  ASSERT_EQ(five.curve.positions.size(), 5U);
  for (int k = 0; k < 5; ++k) {
    EXPECT_LT((five.curve.positions[k] - Point(0.75 * k, 0, 0)).norm(), 1e-15) << k;
  }
  EXPECT_EQ(five.curve.vertices.front(), VertexId{0U});
  EXPECT_EQ(five.curve.vertices.back(), VertexId{3U});
  EXPECT_FALSE(five.curve.vertices[1].valid());
  EXPECT_EQ(resampled(mesh_, side(), {2, 0}).curve.positions.size(), 2U);
}

TEST_F(Resampling, AClosedCurveDoesNotRepeatItsFirstPoint) {
  const ResampledCurve eight = resampled(mesh_, square(), {8, 0});
  EXPECT_TRUE(eight.curve.closed);
  EXPECT_DOUBLE_EQ(eight.spacing, 0.5);
  const std::vector<Point> expected{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 0.5, 0},
                                    {1, 1, 0}, {0.5, 1, 0}, {0, 1, 0}, {0, 0.5, 0}};
  ASSERT_EQ(eight.curve.positions.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_LT((eight.curve.positions[k] - expected[k]).norm(), 1e-15) << k;
  }
}

TEST_F(Resampling, ASpacingIsRoundedToEqualSteps) {
  EXPECT_EQ(resampled(mesh_, side(), {{}, 0.7}).curve.positions.size(), 5U);  // 3 / 0.7 = 4.3 steps
  EXPECT_DOUBLE_EQ(resampled(mesh_, side(), {{}, 0.7}).spacing, 0.75);
  EXPECT_EQ(resampled(mesh_, side(), {{}, 100}).curve.positions.size(), 2U);
  EXPECT_EQ(resampled(mesh_, square(), {{}, 100}).curve.positions.size(), 3U);
  EXPECT_EQ(resampled(mesh_, square(), {{}, 0.1}).curve.positions.size(), 40U);
}

TEST_F(Resampling, PointsLieInTheFacesThatTheyName) {
  const SurfaceMesh ball = SurfaceMesh::open(test::sphere(3));
  const Surface& surface = ball.surface();
  SurfaceCurve meridian{false, {}};
  for (const VertexId v :
       draw_edge_path(surface, std::vector<VertexId>{VertexId{4U}, VertexId{5U}}))
    meridian.points.push_back(SurfacePoint::at_vertex(surface, v));
  const ResampledCurve even = resampled(ball, meridian, {101, 0});
  double length = 0;
  for (std::size_t k = 0; k < even.curve.positions.size(); ++k) {
    const auto corners = surface.corners(even.curve.faces[k].face);
    Point there = Point::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      there += even.curve.faces[k].barycentric[c] * ball.point(corners[c]);
    }
    EXPECT_LT((there - even.curve.positions[k]).norm(), 1e-15);
    if (k > 0) {
      const double step = (even.curve.positions[k] - even.curve.positions[k - 1]).norm();
      EXPECT_LE(step, even.spacing * (1 + 1e-12));
      length += step;
    }
  }
  // At each of the 15 bends by pi / 16, a step is shorter by at most 1 - cos(pi / 32) of its
  // length.
  EXPECT_NEAR(length, 100 * even.spacing, 15 * even.spacing * (1 - std::cos(M_PI / 32)));
}

TEST_F(Resampling, RefusesTooFewAndTooMany) {
  const auto code = [&](const SurfaceCurve& curve, const EvenPoints& even) {
    try {
      resampled(mesh_, curve, even);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kNumerical;
  };
  EXPECT_EQ(code(side(), {1, 0}), ErrorCode::kBadUsage);
  EXPECT_EQ(code(square(), {2, 0}), ErrorCode::kBadUsage);
  EXPECT_EQ(code(side(), {{}, 0}), ErrorCode::kBadUsage);
  EXPECT_EQ(code(side(), {{}, 1e-12}), ErrorCode::kBadUsage);
  EXPECT_EQ(code(side(), {std::size_t{1} << 60U, 0}), ErrorCode::kBadUsage);
  EXPECT_EQ(code({false, {at(0), at(15)}}, {5, 0}), ErrorCode::kBadCurve);
  EXPECT_EQ(code({false, {at(0)}}, {5, 0}), ErrorCode::kBadCurve);
}

}  // namespace
}  // namespace talweg
