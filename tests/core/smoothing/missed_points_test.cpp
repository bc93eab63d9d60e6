// The result of a drawing that meets itself may miss points to pass; the report then contains them.
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class MissedPoints : public testing::Test {
 protected:
  static constexpr std::uint32_t columns = 31;
  [[nodiscard]] static VertexId at(std::uint32_t x, std::uint32_t y) {
    return VertexId{y * columns + x};
  }
  /// Along rows and columns from one corner to the next; the corners are way-points. The last
  /// stretch may be painted.
  [[nodiscard]] SmoothingResult smooth_through(
      const std::vector<std::pair<std::uint32_t, std::uint32_t>>& corners,
      bool painted = false) const {
    const Surface& surface = opened->mesh().surface();
    CurveOptions options;
    SurfaceCurve drawn{false, {}};
    auto [x, y] = corners.front();
    const auto step = [](std::uint32_t from, std::uint32_t to) {
      return from < to ? from + 1 : from > to ? from - 1 : from;
    };
    for (const auto& [to_x, to_y] : corners) {
      for (; x != to_x || y != to_y; x = step(x, to_x), y = step(y, to_y)) {
        drawn.points.push_back(SurfacePoint::at_vertex(surface, at(x, y)));
      }
      options.way_points.push_back({SurfacePoint::at_vertex(surface, at(x, y))});
    }
    drawn.points.push_back(SurfacePoint::at_vertex(surface, at(x, y)));
    if (painted) options.painted.push_back(drawn.points[drawn.points.size() - 2]);
    return smooth_curve(opened, drawn, {}, options);
  }
  [[nodiscard]] static std::vector<std::string> said(const SmoothingResult& result) {
    std::vector<std::string> said;
    std::ranges::copy_if(result.total.warnings, std::back_inserter(said), [](const auto& warning) {
      return warning.find("it should pass") != std::string::npos;
    });
    return said;
  }
  static void expect_six_away(const SmoothingResult& result) {
    const std::vector<std::string> warnings = said(result);
    ASSERT_EQ(warnings.size(), 1);
    EXPECT_EQ(result.report().termination, Outcome::kMissed);
    EXPECT_NE(warnings[0].find("misses 1 of the points"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("by up to 6 mesh units through space, at (20, 10, 0)"),
              std::string::npos)
        << warnings[0];
    EXPECT_TRUE(std::ranges::any_of(result.report().decisive, [&](const Decisive& one) {
      return one.sentence == warnings[0] && one.at == Point(20, 10, 0);
    }));
    const Farthest far = farthest(result.report());
    EXPECT_EQ(far.of, FarthestOf::kPoint);
    EXPECT_NEAR(far.at_least, 6, 1e-6);
    EXPECT_NEAR((far.at - Point(20, 10, 0)).norm(), 0, 1e-9);
  }
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(30, 30));
};

TEST_F(MissedPoints, AreNotMentionedIfAllPointsArePassed) {
  EXPECT_TRUE(said(smooth_through({{2, 2}, {2, 12}, {14, 12}, {14, 4}})).empty());
}

TEST_F(MissedPoints, LegsMayGoBackAndCross) {
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> back{{2, 10},  {20, 10}, {14, 10},
                                                                  {14, 20}, {6, 20},  {6, 4}};
  const SmoothingResult result = smooth_through(back);
  EXPECT_TRUE(said(result).empty());
  EXPECT_EQ(result.report().termination, Outcome::kConverged);
}

TEST_F(MissedPoints, AWayBackBesideAStrokeIsLeftOut) {
  // From (20, 10) it goes back to (14, 10).
  expect_six_away(smooth_through({{2, 10}, {20, 10}, {14, 10}, {14, 20}}, true));
  // Later it crosses its beginning.
  expect_six_away(smooth_through({{2, 10}, {20, 10}, {14, 10}, {14, 20}, {6, 20}, {6, 4}}, true));
}

/// In UTM coordinates, 4200 km from the origin, the place still tells which vertex is meant.
TEST(MissedPointsFarFromTheOrigin, AreToldToTheVertex) {
  MeshLists lists = test::grid(30, 30);
  for (Point& p : lists.points) p += Point(500000, 4200000, 0);
  const auto opened = OpenedMesh::open(lists);
  const auto vertex = [&](std::uint32_t x, std::uint32_t y) {
    return SurfacePoint::at_vertex(opened->mesh().surface(), VertexId{y * 31 + x});
  };
  SurfaceCurve drawn{false, {}};
  for (std::uint32_t x = 2; x <= 20; ++x) drawn.points.push_back(vertex(x, 10));
  for (std::uint32_t x = 19; x >= 14; --x) drawn.points.push_back(vertex(x, 10));
  for (std::uint32_t y = 11; y <= 20; ++y) drawn.points.push_back(vertex(14, y));
  CurveOptions options;
  options.way_points.push_back({vertex(20, 10)});
  options.painted.push_back(vertex(14, 19));
  const SmoothingResult result = smooth_curve(opened, drawn, {}, options);
  EXPECT_TRUE(std::ranges::any_of(result.report().decisive, [](const Decisive& one) {
    return one.sentence.find("it should pass") != std::string::npos &&
           one.sentence.find("at (500020, 4200010, 0)") != std::string::npos;
  }));
}

}  // namespace
}  // namespace talweg
