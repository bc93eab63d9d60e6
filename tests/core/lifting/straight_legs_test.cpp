// Each straight leg is a geodesic, and only legs that were redrawn are straightened again.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class StraightLegsOnHills : public testing::Test {
 protected:
  static constexpr std::uint32_t columns = 61;

  [[nodiscard]] const Surface& surface() const { return opened->surface(); }
  [[nodiscard]] Drawing through(const std::vector<VertexId>& clicks, bool closed = false) const {
    return draw(surface(), clicks, {.closed = closed});
  }
  /// The number of legs that are embedded to straighten a drawing.
  std::size_t straightened(const Drawing& drawing) {
    std::size_t embedded = 0;
    const Progress progress = [&](const char* stage, double /*fraction*/) {
      if (std::string(stage) == "embed") ++embedded;
      return true;
    };
    smoother->set_curve(drawing);
    last = smoother->smooth(SmoothingOptions{.tau = 0}, progress);
    return embedded;
  }
  static VertexId at(std::uint32_t x, std::uint32_t y) { return VertexId{y * columns + x}; }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::hills(60));
  std::optional<CurveSmoother> smoother{std::in_place, opened};
  SmoothingResult last;
};

TEST_F(StraightLegsOnHills, OnlyTheLegsBesideAMovedPointAreMadeAnew) {
  std::vector<VertexId> clicks{at(5, 10), at(17, 30), at(30, 12), at(40, 33), at(54, 25)};
  EXPECT_EQ(straightened(through(clicks)), 4U);
  EXPECT_EQ(straightened(through(clicks)), 0U);
  clicks[2] = at(31, 14);
  EXPECT_EQ(straightened(through(clicks)), 2U);
  Drawing reversed = through(clicks);
  std::reverse(reversed.curve.points.begin(), reversed.curve.points.end());
  EXPECT_EQ(straightened(reversed), 0U);
  clicks.pop_back();
  EXPECT_EQ(straightened(through(clicks)), 0U);
  clicks.push_back(at(20, 50));
  EXPECT_EQ(straightened(through(clicks)), 1U);
  EXPECT_EQ(straightened(through(clicks, true)), 1U);
}

TEST_F(StraightLegsOnHills, KeptLegsEqualNewlyMadeLegs) {
  std::vector<VertexId> clicks{at(5, 10), at(17, 30), at(30, 12), at(40, 33)};
  straightened(through(clicks));
  clicks.push_back(at(50, 50));
  EXPECT_EQ(straightened(through(clicks)), 1U);
  const SmoothingResult kept = last;
  smoother.emplace(opened);
  EXPECT_EQ(straightened(through(clicks)), 4U);
  EXPECT_EQ(kept.curve().points, last.curve().points);
  EXPECT_EQ(kept.report().after.length, last.report().after.length);
  EXPECT_EQ(kept.report().flips, last.report().flips);
  EXPECT_EQ(kept.report().faces_touched, last.report().faces_touched);
}

class StraightLegsOnAPlane : public testing::Test {
 protected:
  static constexpr std::uint32_t columns = 31;

  [[nodiscard]] SurfacePoint at(std::uint32_t x, std::uint32_t y) const {
    return SurfacePoint::at_vertex(opened->surface(), VertexId{y * columns + x});
  }
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(30, 30));
};

TEST_F(StraightLegsOnAPlane, LegsThatWouldCrossEachOtherAreStraightenedTogether) {
  // The second leg goes around the beginning of the first leg; straight, it would cross the first
  // leg.
  std::vector<VertexId> around;
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> way = {
      {10, 15}, {20, 15}, {20, 25}, {5, 25}, {5, 5}, {15, 5}, {15, 12}};
  for (const auto& [x, y] : way) around.emplace_back(y * columns + x);
  const SurfaceCurve drawn = test::vertex_curve(
      opened->surface(), draw_edge_path(opened->surface(), around, false), false);
  CurveSmoother smoother(opened);
  // The straight line from (20, 25) to (15, 12) crosses the first leg between (10, 15) and (20,
  // 15).
  smoother.set_curve(drawn,
                     {.way_points = {{at(10, 15)}, {at(20, 15)}, {at(20, 25)}, {at(15, 12)}}});
  for (const double tau : {0.0, 1.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    EXPECT_TRUE(crossing_curves(opened->surface(), result.curves).empty()) << tau;
    EXPECT_EQ(result.total.crossings_after, 0U);
  }
}

TEST_F(StraightLegsOnAPlane, LegsThatWouldMeetAtAPointAreStraightenedTogether) {
  // Straight, the last leg would pass the vertex (15, 15), where the first two legs meet.
  std::vector<VertexId> around;
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> way = {
      {5, 10}, {15, 15}, {25, 10}, {25, 25}, {3, 25}, {3, 3}, {15, 3}, {15, 5}};
  for (const auto& [x, y] : way) around.emplace_back(y * columns + x);
  const SurfaceCurve drawn = test::vertex_curve(
      opened->surface(), draw_edge_path(opened->surface(), around, false), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(
      drawn, {.way_points = {{at(5, 10)}, {at(15, 15)}, {at(25, 10)}, {at(15, 25)}, {at(15, 5)}}});
  const SmoothingResult result = smoother.smooth(0.0);
  const auto& points = result.curve().points;
  EXPECT_EQ(std::count(points.begin(), points.end(), at(15, 15)), 1);
  EXPECT_TRUE(crossing_curves(opened->surface(), result.curves).empty());
}

}  // namespace
}  // namespace talweg
