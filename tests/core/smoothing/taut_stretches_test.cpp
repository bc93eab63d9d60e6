#include "talweg/core/smoothing/taut_stretches.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kStretchColumns = 20;
constexpr double kStretchSpacing = 0.3;

class TautStretchesTest : public testing::Test {
 protected:
  [[nodiscard]] SurfaceCurve through(const std::vector<std::array<std::uint32_t, 2>>& corners,
                                     bool closed) const {
    std::vector<VertexId> way;
    for (const auto& [i, j] : corners) way.emplace_back(j * (kStretchColumns + 1) + i);
    return test::vertex_curve(surface, draw_edge_path(surface, way, closed), closed);
  }
  /// The places of the points along the curve.
  [[nodiscard]] std::vector<double> arcs(const SurfaceCurve& curve) const {
    std::vector<double> arcs;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const auto first = curve.points.begin();
      arcs.push_back(
          curve_length(surface, {false, {first, first + static_cast<std::ptrdiff_t>(i) + 1}}));
    }
    return arcs;
  }
  [[nodiscard]] static std::size_t find(const SurfaceCurve& curve, const SurfacePoint& point) {
    return static_cast<std::size_t>(std::ranges::find(curve.points, point) - curve.points.begin());
  }
  /// Each point of the curve is one of the held curve, which has its length, and between the ends
  /// of a stretch points that stay leave no room for others.
  void expect_held(const SurfaceCurve& curve, const HeldCurve& held) const {
    for (const SurfacePoint& point : curve.points) {
      EXPECT_LT(find(held.curve, point), held.curve.points.size());
    }
    EXPECT_NEAR(curve_length(surface, held.curve), curve_length(surface, curve), 1e-12);
    const std::vector<double> at = arcs(held.curve);
    for (const StretchEnds& ends : held.ends) {
      const std::size_t from = find(held.curve, ends[0]), to = find(held.curve, ends[1]);
      ASSERT_LT(from, to);
      auto stays = std::ranges::find(held.fixed, from);
      ASSERT_NE(stays, held.fixed.end());
      for (; *stays != to; ++stays) {
        ASSERT_NE(stays + 1, held.fixed.end());
        EXPECT_LE(at[*(stays + 1)] - at[*stays], kStretchSpacing * (1 + 1e-9));
      }
    }
  }

  const std::shared_ptr<const OpenedMesh> opened =
      OpenedMesh::open(test::grid(kStretchColumns, 20));
  const Surface& surface = opened->surface();
  const SurfaceCurve bent = through({{2, 2}, {10, 2}, {10, 12}}, false);  // 18 long
  const SurfaceCurve square = through({{2, 2}, {12, 2}, {12, 12}, {2, 12}}, true);
};

TEST_F(TautStretchesTest, StayAndTheRestIsAsItWas) {
  TautStretches stretches(surface, bent);
  EXPECT_FALSE(stretches.any());
  stretches.add(4.5, 0.7);
  stretches.add(15, 1);
  const auto held = stretches.held(kStretchSpacing);
  ASSERT_TRUE(held);
  ASSERT_EQ(held->ends.size(), 2U);
  expect_held(bent, *held);
  EXPECT_GE(held->share, 3.4 / 18);
  EXPECT_LE(held->share, 3.4 / 18 + 8 * kStretchSpacing / 18);
  EXPECT_TRUE(stretches.contain(4.5));
  EXPECT_FALSE(stretches.contain(8));
}

TEST_F(TautStretchesTest, BeginAndEndWhereTheCurveIsStraight) {
  TautStretches stretches(surface, bent);
  stretches.add(7, 1.1);  // just over the bend at 8
  const auto held = stretches.held(kStretchSpacing);
  ASSERT_TRUE(held);
  expect_held(bent, *held);
  const std::vector<double> at = arcs(held->curve);
  EXPECT_GE(at[find(held->curve, held->ends[0][1])], 8 + kStretchSpacing);
  const auto corner = SurfacePoint::at_vertex(surface, VertexId{2 * (kStretchColumns + 1) + 10});
  EXPECT_NE(std::ranges::find(held->corners, corner), held->corners.end());
  for (const SurfacePoint& end : held->ends[0]) {
    EXPECT_EQ(std::ranges::find(held->corners, end), held->corners.end());
  }
}

TEST_F(TautStretchesTest, OfALoopGoOnOverItsStart) {
  for (const double arc : {0.2, 39.8, 20.0}) {
    TautStretches stretches(surface, square);
    stretches.add(arc, 1);
    const auto held = stretches.held(kStretchSpacing);
    ASSERT_TRUE(held);
    EXPECT_TRUE(held->curve.closed);
    EXPECT_EQ(held->ends.size(), 1U);
    expect_held(square, *held);
    EXPECT_TRUE(stretches.contain(arc));
    EXPECT_FALSE(stretches.contain(10));
  }
}

TEST_F(TautStretchesTest, LeaveSomethingOrThereAreNone) {
  TautStretches all(surface, bent);
  all.add(9, 9);
  EXPECT_FALSE(all.held(kStretchSpacing));
  TautStretches loop(surface, square);
  loop.add(3, 20);
  EXPECT_FALSE(loop.held(kStretchSpacing));
  TautStretches start(surface, bent);
  start.add(0, 2);
  const auto held = start.held(kStretchSpacing);
  ASSERT_TRUE(held);
  EXPECT_EQ(held->ends[0][0], bent.points.front());
}

}  // namespace
}  // namespace talweg
