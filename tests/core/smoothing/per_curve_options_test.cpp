// Curves of one set with separate tau, slack and finish.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class PerCurveOptions : public testing::Test {
 protected:
  /// From left to right over the hills, up and down around a height.
  [[nodiscard]] SurfaceCurve wave(std::uint32_t height) const {
    std::vector<std::uint32_t> way;
    for (std::uint32_t k = 0; k < 10; ++k) way.push_back((height + (k % 2) * 3) * 41 + 2 + 4 * k);
    return test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), test::ids(way)),
                              false);
  }
  [[nodiscard]] SmoothingResult smooth(const SmoothingOptions& options) const {
    CurveSmoother smoother(opened);
    smoother.set_curves(curves);
    return smoother.smooth(options);
  }
  /// Each curve equals its result when its options are used for all curves.
  void expect_as_common(const SmoothingOptions& options) const {
    const SmoothingResult own = smooth(options);
    for (std::size_t c = 0; c < curves.size(); ++c) {
      SmoothingOptions common = options;
      common.per_curve.clear();
      common.tau = options.tau_of(c);
      common.finish = options.finish_of(c);
      common.slack = options.slack_of(c);
      const SmoothingResult all = smooth(common);
      // Slacks of other curves only change the order in which distances are computed.
      EXPECT_LT(test::apart(opened->mesh(), own.curves[c], all.curves[c]), 1e-8) << c;
      EXPECT_EQ(own.reports[c].tau, common.tau);
      EXPECT_EQ(own.reports[c].slack, all.reports[c].slack);
      EXPECT_EQ(own.reports[c].deviation, all.reports[c].deviation);
      EXPECT_EQ(own.reports[c].warnings, all.reports[c].warnings);
    }
  }
  [[nodiscard]] std::string refused(const SmoothingOptions& options,
                                    const CurveOptions& curve_options = {}) const {
    CurveSmoother smoother(opened);
    smoother.set_curves(curves, curve_options);
    try {
      smoother.smooth(options);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      return error.what();
    }
    return "";
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::hills(40));
  const std::vector<SurfaceCurve> curves = {wave(6), wave(19), wave(32)};
};

TEST_F(PerCurveOptions, TausOfTheLadder) {
  expect_as_common({.per_curve = {{.tau = 0.3}, {.tau = 1}, {.tau = 6}}});
  expect_as_common({.tau = 2, .per_curve = {{}, {.tau = 0.125}, {.tau = 100}}});
}

TEST_F(PerCurveOptions, SmallTausBesideLargeOnes) {
  expect_as_common({.per_curve = {{.tau = 0.05}, {.tau = 0.7}, {.tau = 0.1}}});
  expect_as_common({.per_curve = {{.tau = 3}, {.tau = 0}, {.tau = 0.5}}});
  expect_as_common({.per_curve = {{.tau = 0}, {.tau = 0.05}, {.tau = 0}}});
}

TEST_F(PerCurveOptions, SlackAndFinish) {
  expect_as_common({.per_curve = {{.finish = Finish::kTaut}, {}, {.tau = 2}}});
  expect_as_common({.per_curve = {{.tau = 0.4, .slack = 0.3}, {.finish = Finish::kFair}, {}},
                    .finish = Finish::kTaut});
  expect_as_common({.per_curve = {{.slack = 0.2}, {.slack = 1.1}, {}}});
  expect_as_common({.slack = 0.5, .per_curve = {{}, {.slack = 1.1}, {}}});
}

TEST_F(PerCurveOptions, OtherOptionsGoWithThem) {
  expect_as_common({.per_curve = {{.tau = 0.4}, {.tau = 0.4}, {.tau = 3}}, .relax_rounds = 3});
  expect_as_common({.per_curve = {{.tau = 4}, {}, {}}, .prepare_whole_mesh = true});
}

TEST_F(PerCurveOptions, FollowTheirCurvesInAnyOrder) {
  const SmoothingResult first =
      smooth({.per_curve = {{.tau = 0.05}, {.tau = 4}, {.slack = 0.3, .finish = Finish::kTaut}}});
  CurveSmoother smoother(opened);
  smoother.set_curves(std::vector{curves[2], curves[0], curves[1]});
  const SmoothingResult other = smoother.smooth(
      {.per_curve = {{.slack = 0.3, .finish = Finish::kTaut}, {.tau = 0.05}, {.tau = 4}}});
  EXPECT_EQ(other.curves[0].points, first.curves[2].points);
  EXPECT_EQ(other.curves[1].points, first.curves[0].points);
  EXPECT_EQ(other.curves[2].points, first.curves[1].points);
  EXPECT_EQ(other.reports[2].tau, 4);
}

TEST_F(PerCurveOptions, EarlierCallsChangeNothing) {
  const SmoothingOptions asked[] = {
      {.per_curve = {{.tau = 0.3}, {.tau = 1}, {.tau = 6}}},
      {.per_curve = {{.tau = 0.3}, {.tau = 0.02}, {.tau = 6}}},
      {.tau = 3},
      {.per_curve = {{.finish = Finish::kTaut}, {.tau = 1}, {.tau = 6}}},
      {.per_curve = {{.tau = 6}, {.tau = 1}, {.slack = 0.4}}},
  };
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  for (int round = 0; round < 2; ++round) {
    for (const SmoothingOptions& options : asked) {
      const SmoothingResult now = smoother.smooth(options), fresh = smooth(options);
      for (std::size_t c = 0; c < curves.size(); ++c)
        EXPECT_TRUE(now.curves[c].points == fresh.curves[c].points) << c;
    }
  }
}

// Smoothed alone, a curve of small tau might cross its neighbour of large tau.
TEST_F(PerCurveOptions, CurvesOfDifferentTausDoNotCross) {
  const std::vector<SurfaceCurve> near = {wave(18), wave(19), wave(20)};
  for (const SmoothingOptions& options : {
           SmoothingOptions{.per_curve = {{.tau = 0}, {.tau = 8}, {.tau = 0.05}}},
           SmoothingOptions{.per_curve = {{.tau = 0.2}, {.finish = Finish::kTaut}, {.tau = 20}}},
       }) {
    CurveSmoother smoother(opened);
    smoother.set_curves(near);
    const SmoothingResult result = smoother.smooth(options);
    EXPECT_EQ(result.total.termination, Outcome::kConverged);
    CurveSmoother apart(opened);
    apart.set_curves(result.curves);
    for (const SmoothingReport& report : apart.smooth({.tau = 4}).reports) {
      EXPECT_EQ(report.crossings_before, 0U);
    }
  }
}

TEST_F(PerCurveOptions, ADraggedCurveHasItsOwnTau) {
  const SmoothingOptions options = {.per_curve = {{.tau = 0.4}, {.tau = 5}, {.tau = 0.05}}};
  SurfaceCurve moved = curves[1];
  moved.points.pop_back();
  SmoothingOptions common = options;
  common.per_curve.clear();
  common.tau = 5;
  CurveSmoother own(opened), all(opened);
  own.set_curves(curves);
  all.set_curves(curves);
  const SmoothingResult dragged = own.drag(1, moved, options);
  EXPECT_EQ(dragged.curves[1].points, all.drag(1, moved, common).curves[1].points);
  EXPECT_EQ(dragged.reports[1].tau, 5);
  EXPECT_EQ(dragged.curves[0].points, own.smooth(options).curves[0].points);
}

TEST_F(PerCurveOptions, ABoundKeepsTheSlackThatIsGiven) {
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  const SmoothingOptions options = {.per_curve = {{.tau = 7, .slack = 0.25}, {}, {}}};
  const SmoothingResult result = smooth_within(smoother, 2, options);
  EXPECT_EQ(result.reports[0].slack, 0.25);
  EXPECT_NE(result.reports[1].slack, 0.25);
  EXPECT_EQ(result.reports[0].tau, result.reports[1].tau);
  EXPECT_LE(result.total.deviation_to_drawn_max, 2);
}

TEST_F(PerCurveOptions, AreRefusedByASentence) {
  const double nan = std::nan("");
  EXPECT_EQ(refused({.per_curve = {{}, {.tau = -1}, {}}}),
            "per_curve[1].tau must be finite and >= 0.");
  EXPECT_EQ(refused({.per_curve = {{}, {}, {.tau = nan}}}),
            "per_curve[2].tau must be finite and >= 0.");
  EXPECT_EQ(refused({.per_curve = {{.slack = HUGE_VAL}, {}, {}}}),
            "per_curve[0].slack must be finite and >= 0.");
  EXPECT_EQ(refused({.per_curve = {{}, {}}}), "per_curve has options for 2 curves, not for 3.");
  EXPECT_EQ(refused({.per_curve = {{}, {}, {}}}, {.method = Method::kPaper}),
            "per_curve needs the corridor.");
}

}  // namespace
}  // namespace talweg
