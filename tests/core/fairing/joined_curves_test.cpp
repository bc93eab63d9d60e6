// Fair curves continue each other without a kink where exactly two ends of a set meet.
#include "talweg/core/fairing/joined_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr double kDegreeOfTurn = std::numbers::pi / 180;

SurfaceCurve stretch_between(const SurfaceCurve& curve, std::size_t first, std::size_t last) {
  const auto at = [&](std::size_t i) {
    return curve.points.begin() + static_cast<std::ptrdiff_t>(i);
  };
  return {false, {at(first), at(last) + 1}};
}

SurfaceCurve other_way(SurfaceCurve curve) {
  std::reverse(curve.points.begin(), curve.points.end());
  return curve;
}

/// The turning angle between two curves with an end at the point, degrees.
double turn_between(const Surface& surface, const SurfaceCurve& a, const SurfaceCurve& b,
                    const SurfacePoint& point) {
  const auto beside = [&](const SurfaceCurve& curve) {
    EXPECT_TRUE(curve.points.front() == point || curve.points.back() == point);
    return curve.points.front() == point ? curve.points[1] : curve.points[curve.points.size() - 2];
  };
  return std::abs(signed_turning(surface, beside(a), point, beside(b))) / kDegreeOfTurn;
}

class JoinedCurvesTest : public testing::Test {
 protected:
  [[nodiscard]] SmoothingResult smooth(const std::vector<SurfaceCurve>& curves,
                                       const SmoothingOptions& options = {},
                                       const CurveOptions& curve_options = {}) const {
    CurveSmoother smoother(opened);
    smoother.set_curves(curves, curve_options);
    return smoother.smooth(options);
  }
  [[nodiscard]] std::vector<JoinedCurves> groups(const std::vector<SurfaceCurve>& curves,
                                                 const std::vector<SurfacePoint>& corners = {},
                                                 bool may = true) const {
    return joined_curves(surface, curves, corners, [may](auto, auto) { return may; });
  }
  /// A jagged ring on the hills.
  [[nodiscard]] SurfaceCurve ring() const {
    return test::drawn_near(opened->mesh(), test::circle({20, 20, 0}, {12, 0, 0}, {0, 11, 0}, 9),
                            true);
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::hills(40));
  const Surface& surface = opened->surface();
  const SurfaceCurve wave = test::wave_on_hills(opened->mesh());
  const std::size_t n = wave.points.size(), half = n / 2;
};

TEST_F(JoinedCurvesTest, JoinEndsInAnyDirection) {
  const std::vector<SurfaceCurve> curves = {
      other_way(stretch_between(wave, 20, 30)), stretch_between(wave, 0, 9),
      stretch_between(wave, 9, 20), stretch_between(wave, 33, n - 1)};
  const auto all = groups(curves);
  ASSERT_EQ(all.size(), 2U);
  const std::vector<JoinedCurves::Part> expected = {{0, false}, {2, true}, {1, true}};
  EXPECT_TRUE(all[0].parts == expected);
  EXPECT_FALSE(all[0].is_ring);
  EXPECT_TRUE(all[0].is_joined());
  EXPECT_FALSE(all[1].is_joined());
  const SurfaceCurve whole = joined(all[0], curves);
  EXPECT_TRUE(whole.points == other_way(stretch_between(wave, 0, 30)).points);
  const auto where = junctions(all[0], curves);
  EXPECT_TRUE((where == std::vector{wave.points[20], wave.points[9]}));
  const auto parts = split_at_junctions(all[0], where, whole);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(parts[k].points == curves[all[0].parts[k].curve].points) << k;
  }
}

TEST_F(JoinedCurvesTest, CanFormARing) {
  const SurfaceCurve drawn = ring();
  const std::size_t m = drawn.points.size();
  SurfaceCurve rest = stretch_between(drawn, 10, m - 1);
  rest.points.push_back(drawn.points[0]);
  for (const auto& curves : {std::vector{stretch_between(drawn, 0, 10), rest},
                             std::vector{stretch_between(drawn, 0, 10), other_way(rest)}}) {
    const auto all = groups(curves);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_TRUE(all[0].is_ring);
    SurfaceCurve whole = joined(all[0], curves);
    EXPECT_TRUE(whole.closed);
    EXPECT_TRUE(whole.points == drawn.points);
    const auto where = junctions(all[0], curves);
    EXPECT_EQ(where.size(), 2U);
    std::rotate(whole.points.begin(), whole.points.begin() + 4, whole.points.end());
    const auto parts = split_at_junctions(all[0], where, whole);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_TRUE(parts[k].points == curves[k].points) << k;
  }
  SurfaceCurve open = drawn;
  open.closed = false;
  open.points.push_back(drawn.points[0]);
  const auto alone = groups({open});
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_TRUE(alone[0].is_ring);
  EXPECT_TRUE(
      split_at_junctions(alone[0], junctions(alone[0], std::vector{open}), drawn)[0].points ==
      open.points);
}

TEST_F(JoinedCurvesTest, NeedExactlyTwoEndsThatAreFree) {
  const SurfaceCurve a = stretch_between(wave, 0, half), b = stretch_between(wave, half, n - 1);
  const SurfacePoint& there = wave.points[half];
  EXPECT_EQ(groups({a, b}).size(), 1U);
  EXPECT_EQ(groups({a, b}, {there}).size(), 2U);
  EXPECT_EQ(groups({a, b}, {}, false).size(), 2U);
  const VertexId v = std::get<AtVertex>(there.where()).vertex;
  const SurfaceCurve third = test::vertex_curve(
      surface, draw_edge_path(surface, std::vector{v, VertexId{v.index() + 3 * 41}}), false);
  EXPECT_EQ(groups({a, b, third}).size(), 3U);
  SurfaceCurve through = third;
  through.points.insert(through.points.begin(),
                        SurfacePoint::at_vertex(surface, VertexId{v.index() - 41}));
  EXPECT_EQ(groups({a, b, through}).size(), 3U);
  const std::uint32_t left = 10 * 41;  // at the boundary
  const auto from_left = [&](std::uint32_t to) {
    return test::vertex_curve(surface, draw_edge_path(surface, test::ids({left, to})), false);
  };
  EXPECT_EQ(groups({from_left(8 * 41 + 6), from_left(14 * 41 + 6)}).size(), 2U);
}

TEST_F(JoinedCurvesTest, TwoEndsMeetWithoutAKink) {
  const std::vector<SurfaceCurve> curves = {stretch_between(wave, 0, half),
                                            stretch_between(wave, half, n - 1)};
  double apart = 0;
  for (const double tau : {0.05, 0.125, 0.3, 1.0, 1.7, 4.0}) {
    const SmoothingResult result = smooth(curves, {.tau = tau});
    EXPECT_LE(turn_between(surface, result.curves[0], result.curves[1], wave.points[half]), 5)
        << tau;
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_TRUE(result.curves[c].points.front() == curves[c].points.front());
      EXPECT_TRUE(result.curves[c].points.back() == curves[c].points.back());
      for (const std::string& warning : result.reports[c].warnings) {
        EXPECT_EQ(warning.find("fair"), std::string::npos) << warning;
      }
      EXPECT_LE(result.reports[c].after.max_curvature, 5 * kDegreeOfTurn);
    }
    const SmoothingResult other = smooth(curves, {.tau = tau}, {.corners = {wave.points[half]}});
    apart =
        std::max(apart, turn_between(surface, other.curves[0], other.curves[1], wave.points[half]));
  }
  EXPECT_GT(apart, 10);  // fixed as a corner, the same point keeps a kink
}

// Two curves that meet have the same chain of samples and the same walls as one curve with a pin
// there.
TEST_F(JoinedCurvesTest, TwoEndsAreAsAPin) {
  const std::vector<SurfaceCurve> curves = {stretch_between(wave, 0, half),
                                            stretch_between(wave, half, n - 1)};
  for (const double tau : {0.5, 1.0, 3.0}) {
    const SmoothingOptions options = {.tau = tau, .slack = 0.6};
    const SmoothingResult two = smooth(curves, options);
    const SmoothingResult one = smooth({wave}, options, {.pins = {wave.points[half]}});
    EXPECT_LT(test::apart(opened->mesh(), two.curves, one.curves), 0.2) << tau;
  }
}

TEST_F(JoinedCurvesTest, RingsCloseWithoutAKink) {
  const SurfaceCurve drawn = ring();
  const std::size_t m = drawn.points.size();
  SurfaceCurve rest = stretch_between(drawn, 12, m - 1);
  rest.points.push_back(drawn.points[0]);
  for (const double tau : {0.3, 1.0, 5.0}) {
    const SmoothingResult two = smooth({stretch_between(drawn, 0, 12), rest}, {.tau = tau});
    for (const std::size_t at : {0U, 12U}) {
      EXPECT_LE(turn_between(surface, two.curves[0], two.curves[1], drawn.points[at]), 5) << tau;
    }
  }
}

// An open curve whose last point is its first.
TEST_F(JoinedCurvesTest, ACurveThatEndsWhereItBeginsCloses) {
  SurfaceCurve drawn = ring();
  const SurfacePoint there = drawn.points[0];
  drawn.closed = false;
  drawn.points.push_back(there);
  const auto kink = [&](const SurfaceCurve& curve) {
    EXPECT_FALSE(curve.closed);
    EXPECT_TRUE(curve.points.front() == there && curve.points.back() == there);
    return turn_between(surface, {false, {curve.points[0], curve.points[1]}},
                        {false, {curve.points[curve.points.size() - 2], there}}, there);
  };
  for (const double tau : {0.3, 1.0, 5.0}) {
    const SmoothingResult result = smooth({drawn}, {.tau = tau});
    EXPECT_LE(kink(result.curve()), 5) << tau;
    EXPECT_EQ(result.report().termination, Outcome::kConverged);
    EXPECT_TRUE(smooth({other_way(drawn)}, {.tau = tau}).curve().points ==
                other_way(result.curve()).points);
  }
  const std::vector<double> slack(drawn.points.size(), 0.6);
  EXPECT_LE(kink(smooth({drawn}, {.slack_at = {slack}}).curve()), 5);
  EXPECT_GT(kink(smooth({drawn}, {}, {.corners = {there}}).curve()), 20);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  smoother.set_pins(std::span(&drawn.points[9], 1));
  const SurfaceCurve pinned = smoother.smooth(1).curve();
  EXPECT_LE(kink(pinned), 5);
  EXPECT_EQ(std::count(pinned.points.begin(), pinned.points.end(), drawn.points[9]), 1);
}

TEST_F(JoinedCurvesTest, DoNotDependOnTheDirectionOfDrawing) {
  const SurfaceCurve a = stretch_between(wave, 0, 13), b = stretch_between(wave, 13, 29),
                     c = stretch_between(wave, 29, n - 1);
  for (const double tau : {0.4, 1.0, 2.6}) {
    const SmoothingResult first = smooth({a, b, c}, {.tau = tau});
    const SmoothingResult other = smooth({other_way(c), a, other_way(b)}, {.tau = tau});
    EXPECT_TRUE(first.curves[0].points == other.curves[1].points) << tau;
    EXPECT_TRUE(first.curves[1].points == other_way(other.curves[2]).points) << tau;
    EXPECT_TRUE(first.curves[2].points == other_way(other.curves[0]).points) << tau;
  }
}

TEST_F(JoinedCurvesTest, KeepEachItsOwnTauAndWalls) {
  const std::vector<SurfaceCurve> curves = {stretch_between(wave, 0, half),
                                            stretch_between(wave, half, n - 1)};
  CurveSmoother asked(opened);
  asked.set_curves(curves);
  const std::vector<std::pair<double, double>> taus = {{0.4, 6},   {6, 0.4},   {0.05, 3},
                                                       {1.5, 1.2}, {0.5, 100}, {0.4, 6}};
  for (const auto& [first, second] : taus) {
    const SmoothingOptions options = {.slack = 0.5, .per_curve = {{.tau = first}, {.tau = second}}};
    const SmoothingResult result = asked.smooth(options);
    EXPECT_LE(turn_between(surface, result.curves[0], result.curves[1], wave.points[half]), 5)
        << first << " " << second;
    for (std::size_t c = 0; c < 2; ++c) {
      const double walls = 0.5 * 1.25 * (1 + 0.2 / options.tau_of(c));
      EXPECT_LE(result.reports[c].deviation_to_drawn_max, walls * (1 + 1e-9)) << first << second;
      EXPECT_TRUE(result.curves[c].points == smooth(curves, options).curves[c].points);
    }
  }
}

TEST_F(JoinedCurvesTest, NeedTwoFairCurves) {
  const std::vector<SurfaceCurve> curves = {stretch_between(wave, 0, half),
                                            stretch_between(wave, half, n - 1)};
  for (const OwnOptions& own :
       {OwnOptions{.finish = Finish::kTaut}, OwnOptions{.tau = 0}, OwnOptions{.slack = 0.05}}) {
    const SmoothingResult result = smooth(curves, {.per_curve = {{}, own}});
    const SmoothingResult free =
        smooth(curves, {.per_curve = {{}, own}}, {.corners = {wave.points[half]}});
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_TRUE(result.curves[c].points == free.curves[c].points);
    }
  }
}

TEST_F(JoinedCurvesTest, SplinesContinueEachOther) {
  const std::vector<std::uint32_t> clicks = {20 * 41 + 2, 26 * 41 + 8, 24 * 41 + 16, 14 * 41 + 24,
                                             25 * 41 + 33};
  CurveOptions options;
  for (const VertexId v : test::ids(clicks)) {
    options.way_points.push_back({SurfacePoint::at_vertex(surface, v)});
  }
  const auto through = [&](std::size_t first, std::size_t last) {
    const std::vector<std::uint32_t> own(clicks.begin() + static_cast<std::ptrdiff_t>(first),
                                         clicks.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    return test::vertex_curve(surface, draw_edge_path(surface, test::ids(own)), false);
  };
  const SurfacePoint there = options.way_points[2].point;
  for (const bool back : {false, true}) {
    const std::vector<SurfaceCurve> curves = {through(0, 2),
                                              back ? other_way(through(2, 4)) : through(2, 4)};
    const SmoothingResult two = smooth(curves, {}, options);
    EXPECT_LE(turn_between(surface, two.curves[0], two.curves[1], there), 5);
    const SmoothingResult one = smooth({through(0, 4)}, {}, options);
    EXPECT_LT(test::apart(opened->mesh(), two.curves, one.curves), 0.1);
  }
}

}  // namespace
}  // namespace talweg
