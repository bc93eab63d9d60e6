// A fair curve has no kink at pins and way-points, unless the point is a corner.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180;
constexpr std::uint32_t kCornerColumns = 40;

/// The turn of a curve at one of its points, degrees; 0 at its ends.
double turn_of(const Surface& surface, const SurfaceCurve& curve, std::size_t i) {
  const std::size_t n = curve.points.size();
  if (!curve.closed && (i == 0 || i + 1 == n)) return 0;
  const SurfacePoint &before = curve.points[(i + n - 1) % n], &after = curve.points[(i + 1) % n];
  return turning_angle(surface, before, curve.points[i], after) / kOneDegree;
}

/// The turn at a point that the curve passes once.
double turn_of(const Surface& surface, const SurfaceCurve& curve, const SurfacePoint& point) {
  const auto at = std::find(curve.points.begin(), curve.points.end(), point);
  EXPECT_NE(at, curve.points.end());
  return at == curve.points.end()
             ? 0
             : turn_of(surface, curve, static_cast<std::size_t>(at - curve.points.begin()));
}

/// The largest turn at any other point.
double largest_turn_of(const Surface& surface, const SurfaceCurve& curve,
                       const std::vector<SurfacePoint>& but_at = {}) {
  double most = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (std::find(but_at.begin(), but_at.end(), curve.points[i]) != but_at.end()) continue;
    most = std::max(most, turn_of(surface, curve, i));
  }
  return most;
}

VertexId corner_vertex(std::uint32_t column, std::uint32_t row) {
  return VertexId{row * (kCornerColumns + 1) + column};
}

class Corners : public testing::Test {
 protected:
  /// A jagged way along a row, and then along a column; its corner.
  [[nodiscard]] SurfaceCurve angle() const {
    std::vector<VertexId> way;
    for (std::uint32_t k = 4; k <= 28; ++k) way.push_back(corner_vertex(k, k % 2 == 0 ? 8 : 9));
    for (std::uint32_t k = 10; k <= 34; ++k) way.push_back(corner_vertex(k % 2 == 0 ? 28 : 27, k));
    return test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), way), false);
  }
  [[nodiscard]] SurfacePoint at(std::uint32_t column, std::uint32_t row) const {
    return SurfacePoint::at_vertex(opened->surface(), corner_vertex(column, row));
  }
  [[nodiscard]] SurfaceCurve smooth(const SurfaceCurve& drawn, const CurveOptions& options,
                                    double tau = 1) const {
    return smooth_curve(opened, drawn, {.tau = tau}, options).curve();
  }

  const std::shared_ptr<const OpenedMesh> opened =
      OpenedMesh::open(test::grid(kCornerColumns, kCornerColumns));
  const Surface& surface = opened->surface();
};

TEST_F(Corners, PinsArePassedWithoutAKink) {
  const auto hills = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(hills->mesh());
  const std::vector<SurfacePoint> pins = {drawn.points[9], drawn.points[20], drawn.points[31]};
  for (const double tau : {0.2, 1.0, 1.6, 8.0}) {
    const SurfaceCurve curve = smooth_curve(hills, drawn, {.tau = tau}, {.pins = pins}).curve();
    for (const SurfacePoint& pin : pins) {
      EXPECT_LE(turn_of(hills->surface(), curve, pin), 5) << tau;
    }
    EXPECT_LE(largest_turn_of(hills->surface(), curve), 5) << tau;
  }
}

TEST_F(Corners, OfAnAngleIsKeptAndNothingElseTurns) {
  const SurfaceCurve drawn = angle();
  const SurfacePoint corner = at(28, 8);
  for (const double tau : {0.3, 1.0, 5.0}) {
    const SurfaceCurve pinned = smooth(drawn, {.pins = {corner}}, tau);
    const SurfaceCurve free = smooth(drawn, {.corners = {corner}}, tau);
    EXPECT_LE(largest_turn_of(surface, pinned), 5);
    EXPECT_GT(turn_of(surface, free, corner), 80) << tau;
    EXPECT_LE(largest_turn_of(surface, free, {corner}), 5) << tau;
    EXPECT_LT(measure_curve(surface, free).total_curvature,
              measure_curve(surface, pinned).total_curvature);
    EXPECT_LT(free.points.size(), 1.2 * static_cast<double>(pinned.points.size()));
  }
}

TEST_F(Corners, OfASquareMakeItASquare) {
  const std::vector<VertexId> ways = {corner_vertex(8, 8), corner_vertex(30, 8),
                                      corner_vertex(30, 30), corner_vertex(8, 30)};
  const SurfaceCurve drawn = test::vertex_curve(surface, draw_edge_path(surface, ways, true), true);
  std::vector<SurfacePoint> corners;
  for (const VertexId v : ways) corners.push_back(SurfacePoint::at_vertex(surface, v));
  const SurfaceCurve square = smooth(drawn, {.corners = corners});
  for (const SurfacePoint& corner : corners) EXPECT_NEAR(turn_of(surface, square, corner), 90, 5);
  EXPECT_LT(largest_turn_of(surface, square, corners), 2);
  const SurfaceCurve round = smooth(drawn, {});
  EXPECT_LE(largest_turn_of(surface, round), 5);
  // One corner of a loop: a drop.
  const SurfaceCurve drop = smooth(drawn, {.corners = {corners[2]}});
  EXPECT_GT(turn_of(surface, drop, corners[2]), 60);
  EXPECT_LE(largest_turn_of(surface, drop, {corners[2]}), 5);
}

TEST_F(Corners, OfASplineBendAtAWayPoint) {
  const std::vector<VertexId> clicks = {corner_vertex(4, 8), corner_vertex(16, 12),
                                        corner_vertex(28, 8), corner_vertex(24, 20),
                                        corner_vertex(28, 34)};
  const SurfaceCurve drawn = test::vertex_curve(surface, draw_edge_path(surface, clicks), false);
  CurveOptions options;
  for (const VertexId v : clicks) {
    options.way_points.push_back({SurfacePoint::at_vertex(surface, v), 0.4});
  }
  const SurfacePoint corner = options.way_points[2].point;
  EXPECT_LE(largest_turn_of(surface, smooth(drawn, options)), 5);
  options.corners = {corner};
  const SurfaceCurve curve = smooth(drawn, options);
  EXPECT_GT(turn_of(surface, curve, corner), 30);  // the result also passes it exactly
  EXPECT_LE(largest_turn_of(surface, curve, {corner}), 5);
}

TEST_F(Corners, AreTheSameFromTheOtherEndAndWithOtherPins) {
  const SurfaceCurve drawn = angle();
  SurfaceCurve reversed = drawn;
  std::reverse(reversed.points.begin(), reversed.points.end());
  SurfaceCurve back = smooth(reversed, {.pins = {at(16, 8)}, .corners = {at(28, 8)}});
  std::reverse(back.points.begin(), back.points.end());
  const SurfaceCurve there = smooth(drawn, {.pins = {at(16, 8)}, .corners = {at(28, 8)}});
  EXPECT_TRUE(there.points == back.points);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn, {.corners = {at(28, 8)}});
  const SurfacePoint pin = at(16, 8);
  smoother.set_pins(std::span(&pin, 1));
  EXPECT_TRUE(smoother.smooth(1).curve().points == there.points);
}

TEST_F(Corners, StayWhereABoundIsSet) {
  CurveSmoother smoother(opened);
  smoother.set_curve(angle(), {.corners = {at(28, 8)}});
  const SmoothingResult result = smooth_within(smoother, 1.5);
  EXPECT_EQ(result.report().termination, Outcome::kConverged);
  EXPECT_GT(turn_of(surface, result.curve(), at(28, 8)), 60);
}

TEST_F(Corners, MustBePointsOfTheDrawing) {
  CurveSmoother smoother(opened);
  try {
    smoother.set_curve(angle(), {.corners = {at(1, 1)}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
    EXPECT_STREQ(error.what(), "The corner at vertex 42 is not a point of the curve.");
  }
}

}  // namespace
}  // namespace talweg
