// A corridor's result depends on tau and the drawing, not on earlier calls.
#include <algorithm>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class FairLadderTest : public testing::Test {
 protected:
  /// The result of a new smoother.
  [[nodiscard]] std::vector<SurfacePoint> fresh(const SmoothingOptions& options) const {
    return smooth_curve(opened, drawn, options).curve().points;
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
};

TEST_F(FairLadderTest, EarlierCallsChangeNothing) {
  const double taus[] = {0.3, 1, 7};
  std::vector<std::vector<SurfacePoint>> expected;
  for (const double tau : taus) expected.push_back(fresh({.tau = tau}));
  std::vector<std::size_t> order = {0, 1, 2};
  do {
    CurveSmoother asked(opened);
    asked.set_curve(drawn);
    for (const std::size_t i : order) {
      EXPECT_EQ(asked.smooth(taus[i]).curve().points, expected[i]) << taus[i];
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_F(FairLadderTest, OtherSlacksAndOptionsInBetweenChangeNothing) {
  const SmoothingOptions wide = {.tau = 0.6, .slack = 2};
  const SmoothingOptions between[] = {
      wide,
      {.tau = 1.5, .slack_at = {std::vector<double>(drawn.points.size(), 0.4)}},
      {.tau = 1.5, .finish = Finish::kTaut},
      {.tau = 1.5, .relax_rounds = 2},
      {.tau = 1.5, .max_iterations = 3},
      {.tau = 1.5, .length_floor = 4},
      {.tau = 1.5, .prepare_whole_mesh = true},
      {.tau = 0},
      {.tau = 500},
  };
  const auto expected = fresh({.tau = 1.5});
  const auto expected_wide = fresh(wide);
  CurveSmoother asked(opened);
  asked.set_curve(drawn);
  for (const SmoothingOptions& options : between) {
    asked.smooth(options);
    EXPECT_EQ(asked.smooth(1.5).curve().points, expected);
    EXPECT_EQ(asked.smooth(wide).curve().points, expected_wide);
  }
}

TEST_F(FairLadderTest, AnotherDrawingInBetweenChangesNothing) {
  SurfaceCurve other = drawn;
  other.points.erase(other.points.begin() + 20, other.points.end());
  CurveSmoother asked(opened);
  asked.set_curve(drawn);
  asked.smooth(1.5);
  asked.set_curve(other);
  asked.smooth(1.5);
  asked.set_curve(drawn);
  EXPECT_EQ(asked.smooth(1.5).curve().points, fresh({.tau = 1.5}));
}

TEST_F(FairLadderTest, ACancelledCallLeavesNothingBehind) {
  const auto expected = fresh({.tau = 1.5});
  for (const int polls : {0, 1, 2, 5, 20}) {
    CurveSmoother asked(opened);
    asked.set_curve(drawn);
    int left = polls;
    SmoothingOptions options = {.tau = 1.5};
    const Progress progress = [&](const char*, double) { return left-- > 0; };
    const SmoothingResult result = asked.smooth(options, progress);
    if (result.report().termination != Outcome::kCancelled) {
      EXPECT_GT(polls, 0);  // the chains are kept
      EXPECT_EQ(result.curve().points, expected);
    }
    EXPECT_EQ(asked.smooth(1.5).curve().points, expected) << polls;
    EXPECT_EQ(asked.smooth(1.5).report().termination, Outcome::kConverged);
  }
}

/// The number of steps of 1 % in tau, and of steps in which the result moved by more than a fifth
/// of an edge.
struct Sweep {
  int steps = 0, jumps = 0;
};
Sweep sweep(const std::shared_ptr<const OpenedMesh>& opened, const SurfaceCurve& drawn) {
  CurveSmoother asked(opened);
  asked.set_curve(drawn);
  const double edge = asked.smooth(0.5).report().edge_length_near;
  SurfaceCurve last = asked.smooth(0.5).curve();
  Sweep result;
  for (double tau = 0.5 * 1.01; tau < 2; tau *= 1.01, ++result.steps) {
    const SurfaceCurve now = asked.smooth(tau).curve();
    if (test::apart(opened->mesh(), now, last) > 0.2 * edge) ++result.jumps;
    last = now;
  }
  return result;
}

TEST_F(FairLadderTest, TheResultFollowsTau) {
  std::mt19937 random(5);
  Sweep all = sweep(opened, drawn);
  for (int curve = 0; curve < 3; ++curve) {
    std::vector<std::uint32_t> way;
    for (std::uint32_t k = 0; k < 7; ++k)
      way.push_back((10 + static_cast<std::uint32_t>(random() % 21)) * 41 + 2 + 6 * k);
    const auto path = draw_edge_path(opened->surface(), test::ids(way));
    const Sweep one = sweep(opened, test::vertex_curve(opened->surface(), path, false));
    all.steps += one.steps;
    all.jumps += one.jumps;
  }
  EXPECT_GT(all.steps, 500);
  EXPECT_EQ(all.jumps, 0);
}

TEST_F(FairLadderTest, PinsAreMetAndTakenBack) {
  CurveSmoother asked(opened);
  asked.set_curve(drawn);
  const auto expected = asked.smooth(1.5).curve().points;
  const SurfacePoint pins[] = {drawn.points[9], drawn.points[20]};
  asked.set_pins(pins);
  EXPECT_EQ(asked.pins().size(), 2U);
  const auto pinned = asked.smooth(1.5).curve().points;
  for (const SurfacePoint& pin : pins) {
    EXPECT_EQ(std::count(expected.begin(), expected.end(), pin), 0);
    EXPECT_EQ(std::count(pinned.begin(), pinned.end(), pin), 1);
  }
  // Pins set again, pins set from the start, and no pins give consistent results.
  asked.set_pins(asked.pins());
  EXPECT_EQ(asked.smooth(1.5).curve().points, pinned);
  CurveSmoother from_start(opened);
  from_start.set_curve(drawn, {.pins = {pins[0], pins[1]}});
  EXPECT_EQ(from_start.smooth(1.5).curve().points, pinned);
  asked.set_pins({});
  EXPECT_EQ(asked.smooth(1.5).curve().points, expected);
}

TEST_F(FairLadderTest, PinsOfALoop) {
  const SurfaceCurve loop =
      test::drawn_near(opened->mesh(), test::circle({20, 20, 0}, {11, 0, 0}, {0, 9, 0}, 8), true);
  CurveSmoother asked(opened);
  asked.set_curve(loop);
  const auto expected = asked.smooth(1).curve().points;
  asked.set_pins(std::span(&loop.points[7], 1));
  const auto pinned = asked.smooth(1).curve().points;
  EXPECT_EQ(std::count(pinned.begin(), pinned.end(), loop.points[7]), 1);
  asked.set_pins({});
  EXPECT_EQ(asked.smooth(1).curve().points, expected);
}

TEST_F(FairLadderTest, RefusesPinsThatAreNotOnTheDrawing) {
  CurveSmoother asked(opened);
  const auto code = [&](const SurfacePoint& pin) -> std::optional<ErrorCode> {
    try {
      asked.set_pins(std::span(&pin, 1));
    } catch (const Error& error) {
      return error.code();
    }
    return std::nullopt;
  };
  EXPECT_EQ(code(drawn.points[3]), ErrorCode::kBadUsage);  // no curve yet
  asked.set_curve(drawn);
  const auto expected = asked.smooth(1).curve().points;
  const SurfacePoint off = SurfacePoint::at_vertex(opened->surface(), VertexId{0});
  EXPECT_EQ(code(off), ErrorCode::kBadUsage);
  EXPECT_TRUE(asked.pins().empty());
  EXPECT_EQ(asked.smooth(1).curve().points, expected);
  asked.set_curve(drawn, {.method = Method::kPaper});
  EXPECT_EQ(code(drawn.points[3]), ErrorCode::kBadUsage);
}

TEST(FairLadderOfLoops, TheSlackOfAThinLoopDoesNotDependOnPins) {
  const auto plane = OpenedMesh::open(test::grid(30, 30));
  std::vector<VertexId> corners;
  for (const std::uint32_t v : {5U * 31 + 5, 5U * 31 + 25, 7U * 31 + 25, 7U * 31 + 5}) {
    corners.emplace_back(v);
  }
  const SurfaceCurve thin =
      test::vertex_curve(plane->surface(), draw_edge_path(plane->surface(), corners, true), true);
  CurveSmoother plain(plane), pinned(plane);
  plain.set_curve(thin);
  pinned.set_curve(thin, {.pins = {thin.points[3], thin.points[25]}});
  EXPECT_EQ(pinned.slack(), plain.slack());
  pinned.set_pins({});
  EXPECT_EQ(pinned.smooth(0.5).curve().points, plain.smooth(0.5).curve().points);
}

}  // namespace
}  // namespace talweg
